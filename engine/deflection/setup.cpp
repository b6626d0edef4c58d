#include "engine/deflection/setup.h"

#include "engine/core/field_within.h"
#include "engine/core/units.h"
#include "engine/receptance/receptance_fields.h"

namespace lathelier::deflection {
namespace {

const Text N_mm_rad = LT_TEXT("Engine", "N·mm/rad");
constexpr double longest_mm = 1e5;
constexpr double stiffest = 1e18;
constexpr Range stiffness{0, stiffest};
constexpr double leastCorner_mm = 0.01, leastEntering_deg = 10;  // of a tool whose forces are known

Label required(Text name, Text help, Text unit = {})
{
    Label label{name, help, unit};
    label.required = true;
    return label;
}

Label folded(Text name, Text help, Text unit = {})
{
    Label label{name, help, unit};
    label.advanced = true;
    return label;
}

/// The fields of a struct within P, by the keys they have there.
template <class P, class Part>
std::vector<Field<P>> allWithin(Part P::*member)
{
    std::vector<Field<P>> result;
    for (const Field<Part>& inner : fields<Part>()) result.push_back(within(member, inner.info.key));
    return result;
}

}  // namespace

const std::vector<Field<WorkMaterial>>& fieldsOf(const WorkMaterial*)
{
    static const auto all =
        described<WorkMaterial>(allWithin(&WorkMaterial::elastic), allWithin(&WorkMaterial::cutting));
    return all;
}

const std::vector<Field<HoldingSprings>>& fieldsOf(const HoldingSprings*)
{
    using S = HoldingSprings;
    static const auto all = described<S>(
        field("radial_N_mm", &S::radial_N_mm, stiffness,
              required(LT_TEXT("Engine", "Radial stiffness"), LT_TEXT("Engine", "Against deflection."), unit::N_mm)),
        field("axial_N_mm", &S::axial_N_mm, stiffness,
              folded(LT_TEXT("Engine", "Axial stiffness"), LT_TEXT("Engine", "Along the axis; changes no diameter."),
                     unit::N_mm)),
        field(
            "tilt_N_mm_rad", &S::tilt_N_mm_rad, stiffness,
            Label{LT_TEXT("Engine", "Tilting stiffness"), LT_TEXT("Engine", "Against tilting of the axis."), N_mm_rad}),
        field("torsion_N_mm_rad", &S::torsion_N_mm_rad, stiffness,
              folded(LT_TEXT("Engine", "Torsional stiffness"),
                     LT_TEXT("Engine", "About the axis; changes no diameter."), N_mm_rad)));
    return all;
}

const std::vector<Field<SteadyRest>>& fieldsOf(const SteadyRest*)
{
    using R = SteadyRest;
    static const auto all = described<R>(
        field("z_mm", &R::z_mm, {0, longest_mm},
              required(LT_TEXT("Engine", "z"), LT_TEXT("Engine", "From the free end toward the chuck."), unit::mm)),
        field("radial_N_mm", &R::radial_N_mm, stiffness,
              required(LT_TEXT("Engine", "Radial stiffness"), LT_TEXT("Engine", "Of the rest."), unit::N_mm)));
    return all;
}

const std::vector<Field<FollowerRest>>& fieldsOf(const FollowerRest*)
{
    using R = FollowerRest;
    static const auto all = described<R>(
        field("offset_mm", &R::offset_mm, {-longest_mm, longest_mm},
              Label{LT_TEXT("Engine", "Distance from the tool"),
                    LT_TEXT("Engine", "Toward the chuck; negative: behind the tool, on the machined surface."),
                    unit::mm}),
        field("radial_N_mm", &R::radial_N_mm, stiffness,
              required(LT_TEXT("Engine", "Radial stiffness"), LT_TEXT("Engine", "Of the rest."), unit::N_mm)));
    return all;
}

const std::vector<Field<ToolPost>>& fieldsOf(const ToolPost*)
{
    using T = ToolPost;
    static const auto all = described<T>(
        field(
            "radial_N_mm", &T::radial_N_mm, {1, stiffest},
            required(LT_TEXT("Engine", "Radial stiffness"),
                     LT_TEXT("Engine", "Of tool, turret and slide against being pushed out of the work."), unit::N_mm)),
        field("tangential_N_mm", &T::tangential_N_mm, {1, stiffest},
              required(LT_TEXT("Engine", "Tangential stiffness"),
                       LT_TEXT("Engine", "Of tool, turret and slide along the cutting speed."), unit::N_mm)));
    return all;
}

const std::vector<Field<SetupTool>>& fieldsOf(const SetupTool*)
{
    static const auto all = [] {
        auto made = lifted<SetupTool>(fields<Tool>());
        for (Field<SetupTool>& field : made) {
            FieldInfo& info = field.info;
            const bool is_corner = info.key == "corner_radius_mm", is_angle = info.key == "entering_angle_deg";
            info.required = is_corner || is_angle;
            info.optional = info.optional && !info.required;
            if (is_corner) info.minimum = leastCorner_mm;
            if (is_angle) info.minimum = leastEntering_deg, info.maximum = 180 - leastEntering_deg;
        }
        return made;
    }();
    return all;
}

const std::vector<Field<TurningSetup>>& fieldsOf(const TurningSetup*)
{
    using S = TurningSetup;
    static const auto all = described<S>(
        field(
            "stock", &S::stock,
            Label{LT_TEXT("Engine", "Stock"), LT_TEXT("Engine", "File of the stock, relative to the set-up's file.")}),
        field("z_zero_mm", &S::z_zero_mm, {-longest_mm, longest_mm},
              Label{LT_TEXT("Engine", "z of the program's zero"),
                    LT_TEXT("Engine", "z = this less the program's Z; 0: the program's zero is the free end."),
                    unit::mm}),
        group("material", &S::material,
              Label{LT_TEXT("Engine", "Material"), LT_TEXT("Engine", "Of the work, with its cutting coefficients.")}),
        group("tool", &S::tool, Label{LT_TEXT("Engine", "Tool"), LT_TEXT("Engine", "The insert.")}),
        group("chuck", &S::chuck, Label{LT_TEXT("Engine", "Chuck"), LT_TEXT("Engine", "Springs at the chuck face.")}),
        group(
            "tailstock", &S::tailstock,
            Label{LT_TEXT("Engine", "Tailstock"), LT_TEXT("Engine", "Springs at the free end; none: not supported.")}),
        rows("steady_rests", &S::steady_rests, {0, 100},
             Label{LT_TEXT("Engine", "Steady rests"), LT_TEXT("Engine", "Rests that stand at one place.")}),
        group("follower_rest", &S::follower_rest,
              Label{LT_TEXT("Engine", "Follower rest"), LT_TEXT("Engine", "A rest that moves with the tool.")}),
        group("tool_post", &S::tool_post,
              Label{LT_TEXT("Engine", "Tool post"),
                    LT_TEXT("Engine", "Stiffness of tool and turret in series with the work; none: rigid.")}),
        field("contact_length", &S::contact, cutting::contactLengthChoices(),
              Label{LT_TEXT("Engine", "Contact length"), LT_TEXT("Engine", "What counts as the edge in cut.")}),
        field("feed_moment", &S::feed_moment,
              Label{LT_TEXT("Engine", "Moment of the feed force"),
                    LT_TEXT("Engine", "The feed force bends the work, for it acts beside the axis.")}),
        field("slope", &S::slope,
              {{"radial", LT_TEXT("Engine", "radial")}, {"normal", LT_TEXT("Engine", "normal to the contour")}},
              Label{LT_TEXT("Engine", "Depth on slopes"),
                    LT_TEXT("Engine", "Depth and entering angle on cones and arcs: to the axis or to the contour.")}),
        receptance::shearField(&S::shear),
        field("step_mm", &S::step_mm, {1e-3, 100},
              folded(LT_TEXT("Engine", "Step"), LT_TEXT("Engine", "Longest step along z."), unit::mm)));
    return all;
}

}  // namespace lathelier::deflection
