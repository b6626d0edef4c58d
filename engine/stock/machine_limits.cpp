#include "engine/stock/machine_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::stock {

ConvexPolygon regionOf(const ChuckBody& chuck, double stock_length_mm)
{
    const double face_mm = chuck.face_z_mm.value_or(stock_length_mm);
    const double radius_mm = chuck.radius_mm > 0 ? chuck.radius_mm : endless_mm;
    return {{face_mm, -radius_mm}, {endless_mm, -radius_mm}, {endless_mm, radius_mm}, {face_mm, radius_mm}};
}

std::vector<ConvexPolygon> regionsOf(const TailstockBody& tailstock)
{
    if (!tailstock.outline.empty()) {
        std::vector<ConvexPolygon> regions;
        for (std::size_t i = 1; i < tailstock.outline.size(); ++i) {
            const Corner &a = tailstock.outline[i - 1], &b = tailstock.outline[i];
            const double a_mm = std::abs(a.x_mm), b_mm = std::abs(b.x_mm);
            if (a.z_mm != b.z_mm)
                regions.push_back(hullOf({{a.z_mm, -a_mm}, {a.z_mm, a_mm}, {b.z_mm, -b_mm}, {b.z_mm, b_mm}}));
        }
        return regions;
    }
    const double end_mm = tailstock.end_z_mm;
    const double hole_mm = tailstock.centre_hole_mm / 2;
    const double quill_mm = std::max(hole_mm, tailstock.quill_diameter_mm / 2);
    const double cone_mm = (quill_mm - hole_mm) / std::tan(tailstock.cone_angle_deg * std::numbers::pi / 360);
    return {hullOf({{end_mm, -hole_mm},
                    {end_mm, hole_mm},
                    {end_mm - cone_mm, quill_mm},
                    {-endless_mm, quill_mm},
                    {-endless_mm, -quill_mm},
                    {end_mm - cone_mm, -quill_mm}})};
}

const std::vector<Field<ChuckBody>>& fieldsOf(const ChuckBody*)
{
    using C = ChuckBody;
    static const auto all =
        described<C>(field("face_z_mm", &C::face_z_mm, {-longest_mm, longest_mm},
                           Label{LT_TEXT("Engine", "z of the chuck face"),
                                 LT_TEXT("Engine", "From the free end; empty: the end of the stock."), unit::mm}),
                     field("radius_mm", &C::radius_mm, {0, longest_mm},
                           Label{LT_TEXT("Engine", "Radius of the jaws"),
                                 LT_TEXT("Engine", "0: everything beyond the chuck face is the chuck."), unit::mm}));
    return all;
}

const std::vector<Field<TailstockBody>>& fieldsOf(const TailstockBody*)
{
    using T = TailstockBody;
    static const auto all = described<T>(
        field("end_z_mm", &T::end_z_mm, {-longest_mm, longest_mm},
              Label{LT_TEXT("Engine", "z of the supported end"),
                    LT_TEXT("Engine", "Of the faced end that the centre stands in, from the free end of the stock."),
                    unit::mm}),
        field("centre_hole_mm", &T::centre_hole_mm, {0, longest_mm},
              Label{LT_TEXT("Engine", "Centre hole ⌀"), LT_TEXT("Engine", "Its largest diameter."), unit::mm}),
        field("cone_angle_deg", &T::cone_angle_deg, {1, 179},
              Label{LT_TEXT("Engine", "Angle of the centre"), LT_TEXT("Engine", "Included."), unit::deg}),
        field("quill_diameter_mm", &T::quill_diameter_mm, {0, longest_mm},
              Label{LT_TEXT("Engine", "Quill ⌀"), LT_TEXT("Engine", "Of the body behind the centre."), unit::mm}));
    return all;
}

}  // namespace lathelier::stock
