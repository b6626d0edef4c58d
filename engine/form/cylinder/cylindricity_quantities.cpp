#include "engine/form/cylinder/cylindricity_quantities.h"

#include "engine/core/units.h"

namespace lathelier::form {
namespace {

template <FittedCylinder CylindricityResult::*cylinder>
double deviationOf(const CylindricityResult& result)
{
    return (result.*cylinder).CYLt_um;
}

}  // namespace

const std::vector<QuantityOf<FittedCylinder>>& quantitiesOf(const FittedCylinder*)
{
    using C = FittedCylinder;
    static const auto all = describedBy<C>(
        quantity<C>("axis_point_mm", &C::axis_point_mm), quantity<C>("axis_direction", &C::axis_direction),
        quantity<C>("axis_point_x_mm", [](const C& c) { return c.axis_point_mm.x(); },
                    {LT_TEXT("Engine", "x"), unit::mm, 5, false}),
        quantity<C>("axis_point_y_mm", [](const C& c) { return c.axis_point_mm.y(); },
                    {LT_TEXT("Engine", "y"), unit::mm, 5, false}),
        quantity<C>("axis_point_z_mm", [](const C& c) { return c.axis_point_mm.z(); },
                    {LT_TEXT("Engine", "z"), unit::mm, 5, false}),
        quantity<C>("axis_direction_x", [](const C& c) { return c.axis_direction.x(); },
                    {LT_TEXT("Engine", "direction x"), {}, 9, false}),
        quantity<C>("axis_direction_y", [](const C& c) { return c.axis_direction.y(); },
                    {LT_TEXT("Engine", "direction y"), {}, 9, false}),
        quantity<C>("axis_direction_z", [](const C& c) { return c.axis_direction.z(); },
                    {LT_TEXT("Engine", "direction z"), {}, 9, false}),
        quantity<C>("radius_mm", &C::radius_mm, {LT_TEXT("Engine", "Radius (least squares)"), unit::mm, 5}),
        quantity<C>("inner_radius_mm", &C::inner_radius_mm, {LT_TEXT("Engine", "inner radius"), unit::mm, 5}),
        quantity<C>("outer_radius_mm", &C::outer_radius_mm, {LT_TEXT("Engine", "outer radius"), unit::mm, 5}),
        quantity<C>("CYLt_um", &C::CYLt_um, {LT_TEXT("Engine", "CYLt(LSCY)"), unit::um}),
        quantity<C>("CYLp_um", &C::CYLp_um, {LT_TEXT("Engine", "CYLp(LSCY)"), unit::um}),
        quantity<C>("CYLv_um", &C::CYLv_um, {LT_TEXT("Engine", "CYLv(LSCY)"), unit::um}),
        quantity<C>("CYLq_um", &C::CYLq_um, {LT_TEXT("Engine", "CYLq(LSCY)"), unit::um}),
        quantity<C>("contacts", &C::contacts));
    return all;
}

const std::vector<QuantityOf<CylindricityResult>>& quantitiesOf(const CylindricityResult*)
{
    using R = CylindricityResult;
    static const auto all = describedBy<R>(
        quantity<R>("points", &R::points, {LT_TEXT("Engine", "Points"), {}, 0}), part("LSCY", &R::LSCY),
        part("MZCY", &R::MZCY), quantity<R>("MZCY.optimum", [](const R&) { return "local"; }),
        quantity<R>("CYLt_MZCY_um", deviationOf<&R::MZCY>, {LT_TEXT("Engine", "CYLt(MZCY)"), unit::um, 3, false}),
        quantity<R>("length_mm", &R::length_mm, {LT_TEXT("Engine", "Length"), unit::mm}),
        quantity<R>("sections", &R::sections),
        quantity<R>("axis_straightness_um", &R::axis_straightness_um,
                    {LT_TEXT("Engine", "Straightness of the axis of the sections"), unit::um}),
        quantity<R>("points_left_out", &R::points_left_out, {LT_TEXT("Engine", "Points left out"), {}, 0}),
        quantity<R>("point_noise_um", &R::point_noise_um,
                    {LT_TEXT("Engine", "Standard deviation of a point"), unit::um, 3}),
        quantity<R>("CYLt_expanded_uncertainty_um", &R::CYLt_expanded_uncertainty_um,
                    {LT_TEXT("Engine", "Expanded uncertainty (95 %)"), unit::um}),
        quantity<R>("tolerance_um", [](const R& r) { return r.parameters.tolerance_um; },
                    {LT_TEXT("Engine", "Tolerance"), unit::um, 3, false}),
        quantity<R>("decision_rule", [](const R& r) { return key(r.parameters.decision); }),
        quantity<R>("verdict", verdictKey<R>));
    return all;
}

}  // namespace lathelier::form
