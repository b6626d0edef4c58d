#include "engine/core/shaft.h"

namespace lathelier {
namespace {

const Text mm = LT_TEXT("Engine", "mm");
constexpr double longest_mm = 1e5;
constexpr Range anyCount{1, 10000};

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

}  // namespace

double Shaft::length_mm() const
{
    double sum = 0;
    for (const ShaftSegment& segment : segments) sum += segment.length_mm;
    return sum;
}

const std::vector<Field<ShaftSegment>>& fieldsOf(const ShaftSegment*)
{
    using S = ShaftSegment;
    static const auto all = described<S>(
        field("length_mm", &S::length_mm, {-longest_mm, longest_mm},
              required(LT_TEXT("Engine", "Length"), LT_TEXT("Engine", "Along the axis."), mm)),
        field("start_diameter_mm", &S::start_diameter_mm, {0, longest_mm},
              required(LT_TEXT("Engine", "Start ⌀"), LT_TEXT("Engine", "At its end toward the free end."), mm)),
        field("end_diameter_mm", &S::end_diameter_mm, {0, longest_mm},
              required(LT_TEXT("Engine", "End ⌀"), LT_TEXT("Engine", "At its end toward the chuck."), mm)),
        field("bore_diameter_mm", &S::bore_diameter_mm, {0, longest_mm},
              label(LT_TEXT("Engine", "Bore ⌀"), LT_TEXT("Engine", "0: solid."), mm)),
        field("arc_radius_mm", &S::arc_radius_mm, {-longest_mm, longest_mm},
              label(LT_TEXT("Engine", "Arc radius"),
                    LT_TEXT("Engine", "Positive: convex, negative: concave, empty: straight."), mm)),
        field("role", &S::role,
              label(LT_TEXT("Engine", "Role"), LT_TEXT("Engine", "What it is: chamfer, fillet, groove…"))));
    return all;
}

const std::vector<Field<Shaft>>& fieldsOf(const Shaft*)
{
    static const auto all = described<Shaft>(
        field("name", &Shaft::name, label(LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "Of the part."))),
        rows("segments", &Shaft::segments, anyCount,
             required(LT_TEXT("Engine", "Segments"), LT_TEXT("Engine", "From the free end toward the chuck."), {})),
        group("material", &Shaft::material,
              label(LT_TEXT("Engine", "Material"), LT_TEXT("Engine", "Stated for this part."))));
    return all;
}

}  // namespace lathelier
