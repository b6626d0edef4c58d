#include "engine/cam/job.h"

#include <algorithm>

#include "engine/cam/required_label.h"
#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

const Text rpmUnit = LT_TEXT("Engine", "rpm");
constexpr double longest_mm = 1e5;
constexpr Range sizeRange{0, longest_mm}, aboveZeroRange{1e-3, longest_mm}, placeRange{-longest_mm, longest_mm};

const std::vector<FieldChoice>& useChoices()
{
    static const std::vector<FieldChoice> all{{"rough", LT_TEXT("Engine", "roughing")},
                                              {"finish", LT_TEXT("Engine", "finishing")},
                                              {"finish_back", LT_TEXT("Engine", "finishing from the chuck")},
                                              {"groove", LT_TEXT("Engine", "grooving")},
                                              {"part_off", LT_TEXT("Engine", "parting off")},
                                              {"centre_drill", LT_TEXT("Engine", "centre drilling")},
                                              {"thread", LT_TEXT("Engine", "threading")}};
    return all;
}

Field<RoughCutting> feedField()
{
    return field("feed_mm_rev", &RoughCutting::feed_mm_rev, {1e-3, 100},
                 required(LT_TEXT("Engine", "Feed"), LT_TEXT("Engine", "Per revolution."), unit::mm_rev));
}

}  // namespace

const char* key(ToolUse use)
{
    return useChoices().at(static_cast<std::size_t>(use)).key.c_str();
}

Text nameOf(ToolUse use)
{
    return useChoices().at(static_cast<std::size_t>(use)).label;
}

void JobTool::settle()
{
    kind = use == ToolUse::CentreDrill ? ToolKind::Drill
           : use == ToolUse::Thread    ? ToolKind::ThreadingInsert
           : width_mm                  ? ToolKind::Blade
                                       : ToolKind::Insert;
    tip = isThreader() ? 8 : isProfile() && hand == Hand::FromChuck ? 4 : 3;
}

double JobTool::radius_mm() const
{
    return isProfile() || isBlade() ? corner_radius_mm.value_or(0) : 0;
}

double JobTool::backAngle_deg() const
{
    if (!isProfile()) return 90;
    return 180 - entering_angle_deg.value_or(assumed::enteringAngle_deg) -
           tip_angle_deg.value_or(assumed::tipAngle_deg);
}

const JobTool* Job::tool(int number) const
{
    const auto found =
        std::find_if(tools.begin(), tools.end(), [number](const JobTool& t) { return t.number == number; });
    return found == tools.end() ? nullptr : &*found;
}

const JobTool* Job::toolFor(ToolUse use) const
{
    const auto found = std::find_if(tools.begin(), tools.end(), [use](const JobTool& t) { return t.use == use; });
    return found == tools.end() ? nullptr : &*found;
}

const JobTool* Job::partingBlade() const
{
    if (const JobTool* blade = toolFor(ToolUse::PartOff)) return blade;
    return toolFor(ToolUse::Groove);
}

const std::vector<Field<JobStock>>& fieldsOf(const JobStock*)
{
    using S = JobStock;
    static const auto all = described<S>(
        field("diameter_mm", &S::diameter_mm, aboveZeroRange,
              required(LT_TEXT("Engine", "Diameter of the bar"), LT_TEXT("Engine", "Before the first cut."), unit::mm)),
        field("length_mm", &S::length_mm, aboveZeroRange,
              Label{LT_TEXT("Engine", "Length of the bar"),
                    LT_TEXT("Engine", "From its raw end; empty: up to the chuck face and into it."), unit::mm}),
        field("face_allowance_mm", &S::face_allowance_mm, sizeRange,
              Label{LT_TEXT("Engine", "Allowance of the face"),
                    LT_TEXT("Engine", "How far the raw end stands before the finished one."), unit::mm}));
    return all;
}

const std::vector<Field<KeepOutCorner>>& fieldsOf(const KeepOutCorner*)
{
    using C = KeepOutCorner;
    static const auto all = described<C>(
        field("z_mm", &C::z_mm, placeRange,
              required(LT_TEXT("Engine", "z"), LT_TEXT("Engine", "From the free end, negative beyond it."), unit::mm)),
        field("x_mm", &C::x_mm, placeRange,
              required(LT_TEXT("Engine", "Radius"), LT_TEXT("Engine", "From the axis."), unit::mm)));
    return all;
}

const std::vector<Field<JobTailstock>>& fieldsOf(const JobTailstock*)
{
    using T = JobTailstock;
    static const auto all = described<T>(
        field("centre_hole_mm", &T::centre_hole_mm, sizeRange,
              Label{LT_TEXT("Engine", "Centre hole ⌀"), LT_TEXT("Engine", "Its largest diameter."), unit::mm}),
        rows("keep_out", &T::keep_out, {0, 1000},
             Label{LT_TEXT("Engine", "Outline of the tailstock"),
                   LT_TEXT("Engine", "Corners that the tool must keep out of; empty: a centre of 60°.")}));
    return all;
}

const std::vector<Field<JobSetup>>& fieldsOf(const JobSetup*)
{
    using S = JobSetup;
    static const auto all = described<S>(
        field("chuck_face_z_mm", &S::chuck_face_z_mm, placeRange,
              required(LT_TEXT("Engine", "z of the chuck face"),
                       LT_TEXT("Engine", "From the free end of the finished part."), unit::mm)),
        field("jaw_diameter_mm", &S::jaw_diameter_mm, aboveZeroRange,
              Label{LT_TEXT("Engine", "Jaws ⌀"),
                    LT_TEXT("Engine", "Empty: everything beyond the chuck face is the chuck."), unit::mm}),
        field("grip_length_mm", &S::grip_length_mm, sizeRange,
              Label{LT_TEXT("Engine", "Length of the grip"),
                    LT_TEXT("Engine", "The least length to be held; empty: not looked at."), unit::mm}),
        group("tailstock", &S::tailstock,
              Label{LT_TEXT("Engine", "Tailstock"), LT_TEXT("Engine", "At the free end; none: free.")}),
        field("power_kW", &S::power_kW, {0.01, 1e4},
              Label{LT_TEXT("Engine", "Power of the motor"),
                    LT_TEXT("Engine", "Cuts that need more than 80 % of it are remarked; empty: not looked at."),
                    LT_TEXT("Engine", "kW")}),
        field("efficiency", &S::efficiency, {0.1, 1},
              Label{LT_TEXT("Engine", "Efficiency"), LT_TEXT("Engine", "Of the way from the motor to the cut.")}));
    return all;
}

const std::vector<Field<JobTool>>& fieldsOf(const JobTool*)
{
    using T = JobTool;
    static const auto all = [] {
        std::vector<Field<T>> made = lifted<T>(fields<Tool>());
        std::erase_if(made, [](const Field<T>& field) {
            return field.info.key == "kind" || field.info.key == "tip" || field.info.key == "shank_width_mm";
        });
        const std::pair<std::string, std::string> of_drill{"use", key(ToolUse::CentreDrill)};
        for (Field<T>& field : made) {
            FieldInfo& info = field.info;
            if (info.key == "number") {
                info.minimum = 1;
                info.required = true;
                info.help = LT_TEXT("Engine", "As the program calls it.");
            }
            if (info.key == "diameter_mm") info.former.push_back({.key = "width_mm", .where = of_drill});
            if (info.key == "reach_mm") info.former.push_back({.key = "edge_length_mm", .where = of_drill});
        }
        made.insert(made.begin() + 1, field("use", &T::use, useChoices(),
                                            required(LT_TEXT("Engine", "Use"), LT_TEXT("Engine", "What it is for."))));
        made.push_back(field("back_margin_deg", &T::back_margin_deg, {0, 45},
                             Label{LT_TEXT("Engine", "Margin of the back angle"),
                                   LT_TEXT("Engine", "What a planned path keeps below the back angle."), unit::deg}));
        made.push_back(
            field("feed_mm_rev", &T::feed_mm_rev, {1e-3, 100},
                  Label{LT_TEXT("Engine", "Feed"),
                        LT_TEXT("Engine", "Per revolution; empty: that of the cutting data."), unit::mm_rev}));
        for (Field<T>& field : made)
            field.set = [set = field.set](T& tool, const Value& value) {
                set(tool, value);
                tool.settle();
            };
        return made;
    }();
    return all;
}

const std::vector<Field<RoughCutting>>& fieldsOf(const RoughCutting*)
{
    using C = RoughCutting;
    static const auto all = described<C>(
        field("depth_mm", &C::depth_mm, {1e-3, 1000},
              required(LT_TEXT("Engine", "Depth"), LT_TEXT("Engine", "The largest of a pass, on radius."), unit::mm)),
        feedField(),
        field("cutting_speed_m_min", &C::cutting_speed_m_min, {0.01, 1e5},
              required(LT_TEXT("Engine", "Cutting speed"), LT_TEXT("Engine", "At the outer diameter."), unit::m_min)),
        field("allowance_mm", &C::allowance_mm, {0, 100},
              Label{LT_TEXT("Engine", "Allowance"), LT_TEXT("Engine", "Left for the finish, normal to the surface."),
                    unit::mm}));
    return all;
}

const std::vector<Field<FinishCutting>>& fieldsOf(const FinishCutting*)
{
    using C = FinishCutting;
    static const auto all = described<C>(
        field("feed_mm_rev", &C::feed_mm_rev, {1e-3, 100},
              required(LT_TEXT("Engine", "Feed"), LT_TEXT("Engine", "Per revolution."), unit::mm_rev)),
        field("cutting_speed_m_min", &C::cutting_speed_m_min, {0.01, 1e5},
              required(LT_TEXT("Engine", "Cutting speed"), LT_TEXT("Engine", "At the outer diameter."), unit::m_min)));
    return all;
}

const std::vector<Field<JobCutting>>& fieldsOf(const JobCutting*)
{
    using C = JobCutting;
    static const auto all = described<C>(
        field("material", &C::material, Label{LT_TEXT("Engine", "Material"), LT_TEXT("Engine", "Of the work.")}),
        group("rough", &C::rough, Label{LT_TEXT("Engine", "Roughing"), LT_TEXT("Engine", "Its cutting data.")}),
        group("finish", &C::finish, Label{LT_TEXT("Engine", "Finishing"), LT_TEXT("Engine", "Its cutting data.")}));
    return all;
}

const std::vector<Field<SpeedSection>>& fieldsOf(const SpeedSection*)
{
    using S = SpeedSection;
    static const auto all = described<S>(
        field("to_z_mm", &S::to_z_mm, placeRange,
              required(LT_TEXT("Engine", "Up to z"), LT_TEXT("Engine", "Where the section ends."), unit::mm)),
        field("rpm", &S::rpm, {1, 1e6},
              required(LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "Of the finish."), rpmUnit)));
    return all;
}

const std::vector<Field<Job>>& fieldsOf(const Job*)
{
    using J = Job;
    static const auto all = described<J>(
        field("title", &J::title, Label{LT_TEXT("Engine", "Title"), LT_TEXT("Engine", "Of the program.")}),
        group("stock", &J::stock, Label{LT_TEXT("Engine", "Stock"), LT_TEXT("Engine", "The bar.")}),
        group("setup", &J::setup, Label{LT_TEXT("Engine", "Set-up"), LT_TEXT("Engine", "How the work is held.")}),
        rows("tools", &J::tools, {1, 1000},
             required(LT_TEXT("Engine", "Tools"), LT_TEXT("Engine", "Inserts, blades and drills, by number."))),
        group("cutting", &J::cutting,
              Label{LT_TEXT("Engine", "Cutting data"), LT_TEXT("Engine", "Depths, feeds and speeds.")}),
        field("max_rpm", &J::max_rpm, {1, 1e6},
              Label{LT_TEXT("Engine", "Highest speed"), LT_TEXT("Engine", "Of the spindle; empty: not limited."),
                    rpmUnit}),
        rows("sections", &J::sections, {0, 1000},
             Label{LT_TEXT("Engine", "Sections"), LT_TEXT("Engine", "Speeds of the finish by section.")}),
        field("part_off", &J::part_off,
              Label{LT_TEXT("Engine", "Part off"), LT_TEXT("Engine", "Cut the part off at its end.")}),
        field("edge_break_mm", &J::edge_break_mm, {0, 10},
              Label{LT_TEXT("Engine", "Break of edges"), LT_TEXT("Engine", "Chamfer of sharp edges; 0: sharp."),
                    unit::mm}));
    return all;
}

}  // namespace lathelier::cam
