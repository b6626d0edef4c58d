#include "engine/shaft/shaft.h"

#include "engine/core/field_within.h"
#include "engine/core/units.h"

namespace lathelier {
namespace {

constexpr double longest_mm = 1e5;
constexpr double widest_um = 1e6;
constexpr Range lengths_mm{-longest_mm, longest_mm};
constexpr Range diameters_mm{0, longest_mm};
constexpr Range uncertainties_um{0, widest_um};
constexpr Range anyCount{1, 10000};
constexpr Range anyCountOrNone{0, 10000};

Label label(Text name, Text help, Text unit = {})
{
    return {name, help, unit};
}

Label required(Text name, Text help, Text unit)
{
    Label result{name, help, unit};
    result.required = true;
    return result;
}

Label folded(Text name, Text help, Text unit = {})
{
    Label result{name, help, unit};
    result.advanced = true;
    return result;
}

const Text lengthName = LT_TEXT("Engine", "Length");
const Text alongHelp = LT_TEXT("Engine", "Along the axis.");
const Text startName = LT_TEXT("Engine", "Start ⌀");
const Text startHelp = LT_TEXT("Engine", "At its end toward the free end.");
const Text endName = LT_TEXT("Engine", "End ⌀");
const Text endHelp = LT_TEXT("Engine", "At its end toward the chuck.");
const Text arcName = LT_TEXT("Engine", "Arc radius");
const Text arcHelp = LT_TEXT("Engine", "Positive: convex, negative: concave, empty: straight.");
const Text roleName = LT_TEXT("Engine", "Role");
const Text roleHelp = LT_TEXT("Engine", "What it is: chamfer, fillet, groove…");
const Text expandedHelp = LT_TEXT("Engine", "Expanded uncertainty, k = 2.");

/// Its kind by key; a key that is not known is kept.
Field<ShaftMark> markKind(const char* name, const Label& described_as)
{
    return {detail::makeInfo(name, FieldInfo::Kind::Word, described_as),
            [](const ShaftMark& mark) -> Value { return key(mark); },
            [](ShaftMark& mark, const Value& v) {
                const auto& stated = std::get<std::string>(v);
                mark.kind = markKindOf(stated);
                mark.other_kind = mark.kind == MarkKind::Other ? stated : std::string();
            }};
}

/// The optional numbers of a mark.
Field<ShaftMark> markNumber(const char* key, std::optional<double> ShaftMark::*member, Text name, Text unit)
{
    return field(key, member, lengths_mm, folded(name, LT_TEXT("Engine", "Of this kind of mark."), unit));
}

}  // namespace

std::string key(const ShaftMark& mark)
{
    return mark.kind == MarkKind::Other ? mark.other_kind : key(mark.kind);
}

Value nameOf(const ShaftMark& mark)
{
    return mark.kind == MarkKind::Other ? Value(mark.other_kind) : Value(nameOf(mark.kind));
}

double Shaft::length_mm() const
{
    double sum = 0;
    for (const ShaftSegment& segment : segments) sum += segment.length_mm;
    return sum;
}

const std::vector<Field<SizeTolerance>>& fieldsOf(const SizeTolerance*)
{
    using T = SizeTolerance;
    static const auto all = described<T>(
        field("class", &T::iso_class,
              folded(LT_TEXT("Engine", "Tolerance class"), LT_TEXT("Engine", "Of ISO 286-1, such as h6."))),
        field("lower_um", &T::lower_um, {-widest_um, widest_um},
              folded(LT_TEXT("Engine", "Lower limit"), LT_TEXT("Engine", "Deviation of the diameter."), unit::um)),
        field("upper_um", &T::upper_um, {-widest_um, widest_um},
              folded(LT_TEXT("Engine", "Upper limit"), LT_TEXT("Engine", "Deviation of the diameter."), unit::um)));
    return all;
}

const std::vector<Field<SizeUncertainty>>& fieldsOf(const SizeUncertainty*)
{
    using U = SizeUncertainty;
    static const auto all = described<U>(field("z_start_um", &U::z_start_um, uncertainties_um,
                                               folded(LT_TEXT("Engine", "U of its start"), expandedHelp, unit::um)),
                                         field("z_end_um", &U::z_end_um, uncertainties_um,
                                               folded(LT_TEXT("Engine", "U of its end"), expandedHelp, unit::um)),
                                         field("length_um", &U::length_um, uncertainties_um,
                                               folded(LT_TEXT("Engine", "U of its length"), expandedHelp, unit::um)),
                                         field("start_diameter_um", &U::start_diameter_um, uncertainties_um,
                                               folded(LT_TEXT("Engine", "U of the start ⌀"), expandedHelp, unit::um)),
                                         field("end_diameter_um", &U::end_diameter_um, uncertainties_um,
                                               folded(LT_TEXT("Engine", "U of the end ⌀"), expandedHelp, unit::um)),
                                         field("arc_radius_um", &U::arc_radius_um, uncertainties_um,
                                               folded(LT_TEXT("Engine", "U of the radius"), expandedHelp, unit::um)),
                                         field("angle_deg", &U::angle_deg, {0, 90},
                                               folded(LT_TEXT("Engine", "U of the angle"), expandedHelp, unit::deg)));
    return all;
}

const std::vector<Field<MeasuredSize>>& fieldsOf(const MeasuredSize*)
{
    using M = MeasuredSize;
    const Text help = LT_TEXT("Engine", "As measured.");
    static const auto all = described<M>(
        field("length_mm", &M::length_mm, lengths_mm, folded(LT_TEXT("Engine", "Measured length"), help, unit::mm)),
        field("start_diameter_mm", &M::start_diameter_mm, diameters_mm,
              folded(LT_TEXT("Engine", "Measured start ⌀"), help, unit::mm)),
        field("end_diameter_mm", &M::end_diameter_mm, diameters_mm,
              folded(LT_TEXT("Engine", "Measured end ⌀"), help, unit::mm)),
        field("arc_radius_mm", &M::arc_radius_mm, lengths_mm,
              folded(LT_TEXT("Engine", "Measured radius"), help, unit::mm)),
        group("uncertainty", &M::uncertainty, folded(LT_TEXT("Engine", "Uncertainty"), expandedHelp)));
    return all;
}

const std::vector<Field<ShaftSegment>>& fieldsOf(const ShaftSegment*)
{
    using S = ShaftSegment;
    static const auto all = described<S>(
        field("length_mm", &S::length_mm, lengths_mm, required(lengthName, alongHelp, unit::mm)),
        field("start_diameter_mm", &S::start_diameter_mm, diameters_mm, required(startName, startHelp, unit::mm)),
        field("end_diameter_mm", &S::end_diameter_mm, diameters_mm, required(endName, endHelp, unit::mm)),
        field("bore_diameter_mm", &S::bore_diameter_mm, diameters_mm,
              label(LT_TEXT("Engine", "Bore ⌀"), LT_TEXT("Engine", "0: solid."), unit::mm)),
        field("arc_radius_mm", &S::arc_radius_mm, lengths_mm, label(arcName, arcHelp, unit::mm)),
        field("role", &S::role, label(roleName, roleHelp)),
        group("tolerance", &S::tolerance,
              folded(LT_TEXT("Engine", "Tolerance"), LT_TEXT("Engine", "Of the diameter."))),
        group("measured", &S::measured,
              folded(LT_TEXT("Engine", "Measured"), LT_TEXT("Engine", "What a scan said of this row."))),
        field("tie", &S::tie,
              folded(LT_TEXT("Engine", "Tie"), LT_TEXT("Engine", "Cylinders with the same one share a diameter."))),
        field("tolerance_um", &S::tolerance_um, {1e-3, widest_um},
              folded(LT_TEXT("Engine", "Width of the tolerance"),
                     LT_TEXT("Engine", "Of the diameter, where its limits are not stated."), unit::um)),
        field("Rz_um", &S::Rz_um, {1e-3, 1e4},
              folded(LT_TEXT("Engine", "Rz"), LT_TEXT("Engine", "Roughness that the drawing allows."), unit::um)),
        field("thread", &S::thread,
              folded(LT_TEXT("Engine", "Thread"), LT_TEXT("Engine", "Cut on this row, such as M16x1.5."))));
    return all;
}

const std::vector<Field<BoreSegment>>& fieldsOf(const BoreSegment*)
{
    using B = BoreSegment;
    static const auto all =
        described<B>(field("length_mm", &B::length_mm, lengths_mm, required(lengthName, alongHelp, unit::mm)),
                     field("start_diameter_mm", &B::start_diameter_mm, diameters_mm,
                           required(startName, LT_TEXT("Engine", "At its end toward the mouth."), unit::mm)),
                     field("end_diameter_mm", &B::end_diameter_mm, diameters_mm,
                           required(endName, LT_TEXT("Engine", "At its inner end."), unit::mm)),
                     field("arc_radius_mm", &B::arc_radius_mm, lengths_mm, label(arcName, arcHelp, unit::mm)),
                     field("role", &B::role, label(roleName, roleHelp)),
                     group("tolerance", &B::tolerance,
                           folded(LT_TEXT("Engine", "Tolerance"), LT_TEXT("Engine", "Of the diameter."))),
                     group("measured", &B::measured,
                           folded(LT_TEXT("Engine", "Measured"), LT_TEXT("Engine", "What a scan said of this row."))));
    return all;
}

const std::vector<Field<ShaftBore>>& fieldsOf(const ShaftBore*)
{
    using B = ShaftBore;
    static const auto all = described<B>(
        field("from", &B::from, {{"free", LT_TEXT("Engine", "free end")}, {"chuck", LT_TEXT("Engine", "chuck end")}},
              required(LT_TEXT("Engine", "From"), LT_TEXT("Engine", "The end that its mouth is at."), {})),
        rows("segments", &B::segments, anyCount,
             required(LT_TEXT("Engine", "Segments"), LT_TEXT("Engine", "From the mouth inward."), {})));
    return all;
}

const std::vector<Field<ShaftMark>>& fieldsOf(const ShaftMark*)
{
    using M = ShaftMark;
    static const auto all = described<M>(
        markKind("kind", required(LT_TEXT("Engine", "Kind"), LT_TEXT("Engine", "Thread, knurl, keyway, flat…"), {})),
        markNumber("z_start_mm", &M::z_start_mm, LT_TEXT("Engine", "Start z"), unit::mm),
        markNumber("z_end_mm", &M::z_end_mm, LT_TEXT("Engine", "End z"), unit::mm),
        markNumber("angle_deg", &M::angle_deg, LT_TEXT("Engine", "Angle"), unit::deg),
        markNumber("width_mm", &M::width_mm, LT_TEXT("Engine", "Width"), unit::mm),
        markNumber("across_flats_mm", &M::across_flats_mm, LT_TEXT("Engine", "Across flats"), unit::mm),
        markNumber("floor_mm", &M::floor_mm, LT_TEXT("Engine", "Floor from the axis"), unit::mm),
        markNumber("distance_mm", &M::distance_mm, LT_TEXT("Engine", "Distance from the axis"), unit::mm),
        markNumber("pitch_mm", &M::pitch_mm, LT_TEXT("Engine", "Pitch"), unit::mm),
        markNumber("major_mm", &M::major_mm, LT_TEXT("Engine", "Crest ⌀"), unit::mm),
        markNumber("minor_mm", &M::minor_mm, LT_TEXT("Engine", "Root ⌀"), unit::mm),
        markNumber("starts", &M::starts, LT_TEXT("Engine", "Starts"), {}),
        markNumber("hand", &M::hand, LT_TEXT("Engine", "Hand"), {}),
        markNumber("teeth", &M::teeth, LT_TEXT("Engine", "Teeth"), {}),
        markNumber("helix_deg", &M::helix_deg, LT_TEXT("Engine", "Helix angle"), unit::deg),
        markNumber("diameter_mm", &M::diameter_mm, LT_TEXT("Engine", "Diameter"), unit::mm),
        markNumber("depth_mm", &M::depth_mm, LT_TEXT("Engine", "Depth"), unit::mm),
        markNumber("through", &M::through, LT_TEXT("Engine", "Through"), {}),
        markNumber("count", &M::count, LT_TEXT("Engine", "Count"), {}),
        markNumber("pitch_circle_mm", &M::pitch_circle_mm, LT_TEXT("Engine", "Pitch circle ⌀"), unit::mm),
        markNumber("offset_mm", &M::offset_mm, LT_TEXT("Engine", "Offset from the axis"), unit::mm),
        markNumber("deviation_mm", &M::deviation_mm, LT_TEXT("Engine", "Deviation"), unit::mm),
        markNumber("uncertainty_mm", &M::uncertainty_mm, LT_TEXT("Engine", "U of its size"), unit::mm),
        markNumber("place_uncertainty_mm", &M::place_uncertainty_mm, LT_TEXT("Engine", "U of its place"), unit::mm),
        markNumber("depth_uncertainty_mm", &M::depth_uncertainty_mm, LT_TEXT("Engine", "U of its depth"), unit::mm),
        markNumber("angle_uncertainty_deg", &M::angle_uncertainty_deg, LT_TEXT("Engine", "U of its angle"), unit::deg),
        field("designation", &M::designation,
              folded(LT_TEXT("Engine", "Designation"), LT_TEXT("Engine", "By its standard."))));
    return all;
}

const std::vector<Field<RecoveredFrom>>& fieldsOf(const RecoveredFrom*)
{
    using R = RecoveredFrom;
    const Text help = LT_TEXT("Engine", "Of a shaft that was recovered from a scan.");
    static const auto all = described<R>(
        field("recovered_from_scan", &R::scan, folded(LT_TEXT("Engine", "Scan"), help)),
        field("recovered_from_sha256", &R::scan_sha256, folded(LT_TEXT("Engine", "SHA-256 of the scan"), help)),
        field("recovered_by_method", &R::method, folded(LT_TEXT("Engine", "Method of the recognition"), help)),
        field("recovered_stated_length_mm", &R::stated_length_mm, {1e-3, longest_mm},
              folded(LT_TEXT("Engine", "Stated length"),
                     LT_TEXT("Engine", "By a person, where the scan does not show an end."), unit::mm)));
    return all;
}

const std::vector<Field<Shaft>>& fieldsOf(const Shaft*)
{
    static const auto all = described<Shaft>(
        field("name", &Shaft::name, label(LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "Of the part."))),
        rows("segments", &Shaft::segments, anyCount,
             required(LT_TEXT("Engine", "Segments"), LT_TEXT("Engine", "From the free end toward the chuck."), {})),
        group("material", &Shaft::material,
              label(LT_TEXT("Engine", "Material"), LT_TEXT("Engine", "Stated for this part."))),
        rows("bores", &Shaft::bores, {0, 2},
             folded(LT_TEXT("Engine", "Bores"), LT_TEXT("Engine", "One from each end at most."))),
        rows("marks", &Shaft::marks, anyCountOrNone,
             folded(LT_TEXT("Engine", "Marks"), LT_TEXT("Engine", "What is not a body of revolution."))),
        field("general_tolerance", &Shaft::general_tolerance,
              folded(LT_TEXT("Engine", "General tolerance"), LT_TEXT("Engine", "Such as ISO 2768-m."))),
        within(&Shaft::recovered, "recovered_from_scan"), within(&Shaft::recovered, "recovered_from_sha256"),
        within(&Shaft::recovered, "recovered_by_method"), within(&Shaft::recovered, "recovered_stated_length_mm"));
    return all;
}

}  // namespace lathelier
