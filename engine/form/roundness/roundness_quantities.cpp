#include "engine/form/roundness/roundness_quantities.h"

#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::form {
namespace {

const char* filterMethodKey(signal::FilterMethod way)
{
    switch (way) {
        case signal::FilterMethod::Uniform: return "uniform";
        case signal::FilterMethod::Series: return "series";
        case signal::FilterMethod::Regression: return "regression";
    }
    return "";
}

Rows contactRows(const FittedCircle& circle)
{
    Rows rows;
    for (const CircleContact& contact : circle.contacts)
        rows.rows.push_back({{{"index", static_cast<std::int64_t>(contact.index)},
                              {"side", contact.side == CircleContact::Side::Outer ? "outer" : "inner"}}});
    return rows;
}

std::string filterWay(const RoundnessResult& result)
{
    return bandOf(result.parameters).isAll() ? "none" : filterMethodKey(result.filter_method);
}

std::int64_t pointsLeftOut(const RoundnessResult& result)
{
    return std::count(result.used.begin(), result.used.end(), std::uint8_t{0});
}

template <ReferenceCircle circle>
double rontOf(const MethodRow& row)
{
    return row.RONt_um[static_cast<std::size_t>(circle)];
}

template <ReferenceCircle circle>
double circleDeviation(const RoundnessResult& result)
{
    return result.circles.of(circle).RONt_um;
}

}  // namespace

const std::vector<QuantityOf<FittedCircle>>& quantitiesOf(const FittedCircle*)
{
    using C = FittedCircle;
    static const auto all = describedBy<C>(
        quantity<C>("RONt_um", &C::RONt_um, {LT_TEXT("Engine", "RONt"), unit::um}),
        quantity<C>("centre_x_mm", [](const C& c) { return c.centre_mm.x(); },
                    {LT_TEXT("Engine", "centre x"), unit::mm, 5}),
        quantity<C>("centre_y_mm", [](const C& c) { return c.centre_mm.y(); },
                    {LT_TEXT("Engine", "centre y"), unit::mm, 5}),
        quantity<C>("radius_mm", &C::radius_mm, {LT_TEXT("Engine", "Radius"), unit::mm, 5}),
        quantity<C>("inner_radius_mm", &C::inner_radius_mm, {LT_TEXT("Engine", "inner radius"), unit::mm, 5}),
        quantity<C>("outer_radius_mm", &C::outer_radius_mm, {LT_TEXT("Engine", "outer radius"), unit::mm, 5}),
        quantity<C>("RONp_um", &C::RONp_um, {LT_TEXT("Engine", "Peak to reference RONp"), unit::um}),
        quantity<C>("RONv_um", &C::RONv_um, {LT_TEXT("Engine", "Reference to valley RONv"), unit::um}),
        quantity<C>("RONq_um", &C::RONq_um, {LT_TEXT("Engine", "Root mean square RONq"), unit::um}),
        quantity<C>("contacts", contactRows),
        quantity<C>("certified_gap_um", &C::certified_gap_um, {LT_TEXT("Engine", "proved to"), unit::um, 7}),
        quantity<C>("unique", &C::unique));
    return all;
}

const std::vector<QuantityOf<ReferenceCircles>>& quantitiesOf(const ReferenceCircles*)
{
    using C = ReferenceCircles;
    static const auto all =
        describedBy<C>(part("LSCI", &C::LSCI), part("MZCI", &C::MZCI), part("MICI", &C::MICI), part("MCCI", &C::MCCI));
    return all;
}

const std::vector<QuantityOf<TwoPointSize>>& quantitiesOf(const TwoPointSize*)
{
    using S = TwoPointSize;
    static const auto all = describedBy<S>(
        quantity<S>("largest_mm", &S::largest_mm, {LT_TEXT("Engine", "Two-point size, largest"), unit::mm, 5}),
        quantity<S>("smallest_mm", &S::smallest_mm, {LT_TEXT("Engine", "Two-point size, smallest"), unit::mm, 5}),
        quantity<S>("range_um", &S::range_um, {LT_TEXT("Engine", "Two-point size range"), unit::um}),
        quantity<S>("half_range_um", &S::half_range_um,
                    {LT_TEXT("Engine", "Half of it: ovality by GOST 24642"), unit::um}),
        quantity<S>("caliper_largest_mm", &S::caliper_largest_mm,
                    {LT_TEXT("Engine", "Width between jaws, largest"), unit::mm, 5}),
        quantity<S>("caliper_smallest_mm", &S::caliper_smallest_mm,
                    {LT_TEXT("Engine", "Width between jaws, smallest"), unit::mm, 5}));
    return all;
}

const std::vector<QuantityOf<MethodRow>>& quantitiesOf(const MethodRow*)
{
    using M = MethodRow;
    static const auto all = describedBy<M>(
        quantity<M>("low_upr", [](const M& row) { return row.band.low_upr; }),
        quantity<M>("high_upr", [](const M& row) { return row.band.high_upr; }),
        quantity<M>("outliers", [](const M& row) { return row.outliers == OutlierRule::Hampel ? "hampel" : "none"; }),
        quantity<M>("RONt_LSCI_um", rontOf<ReferenceCircle::LSCI>),
        quantity<M>("RONt_MZCI_um", rontOf<ReferenceCircle::MZCI>),
        quantity<M>("RONt_MICI_um", rontOf<ReferenceCircle::MICI>),
        quantity<M>("RONt_MCCI_um", rontOf<ReferenceCircle::MCCI>), quantity<M>("undersampled", &M::undersampled));
    return all;
}

const std::vector<QuantityOf<RoundnessHint>>& quantitiesOf(const RoundnessHint*)
{
    using H = RoundnessHint;
    static const auto all =
        describedBy<H>(quantity<H>("upr", &H::upr, {{"UPR"}, {}, 0}),
                       quantity<H>("amplitude_um", &H::amplitude_um, {LT_TEXT("Engine", "Amplitude"), unit::um}),
                       quantity<H>("share_percent", &H::share_percent, {LT_TEXT("Engine", "Share"), unit::percent, 0}),
                       quantity<H>("meaning", &H::meaning, {LT_TEXT("Engine", "Usual cause"), {}, 0}));
    return all;
}

const std::vector<QuantityOf<PaperValues>>& quantitiesOf(const PaperValues*)
{
    using V = PaperValues;
    static const auto all =
        describedBy<V>(quantity<V>("run_out_um", &V::run_out_um,
                                   {LT_TEXT("Engine", "Radial run-out about the spindle axis"), unit::um}),
                       quantity<V>("limacon_centre_um", &V::limacon_centre_um),
                       quantity<V>("limacon_centre_x_um", [](const V& v) { return v.limacon_centre_um.x(); },
                                   {LT_TEXT("Engine", "Centre by the limaçon formula, x"), unit::um, 3, false}),
                       quantity<V>("limacon_centre_y_um", [](const V& v) { return v.limacon_centre_um.y(); },
                                   {LT_TEXT("Engine", "Centre by the limaçon formula, y"), unit::um, 3, false}));
    return all;
}

const std::vector<QuantityOf<RoundnessResult>>& quantitiesOf(const RoundnessResult*)
{
    using R = RoundnessResult;
    static const auto all = describedBy<R>(
        quantity<R>("name", &R::name, {LT_TEXT("Engine", "profile")}), quantity<R>("points", &R::points),
        quantity<R>("points_used", [](const R& r) { return r.evaluated_index.size(); },
                    {LT_TEXT("Engine", "Points used"), {}, 0}),
        quantity<R>("points_left_out", pointsLeftOut, {LT_TEXT("Engine", "Points left out"), {}, 0, false}),
        quantity<R>("filter.low_upr", [](const R& r) { return bandOf(r.parameters).low_upr; }),
        quantity<R>("filter.high_upr", [](const R& r) { return bandOf(r.parameters).high_upr; }),
        quantity<R>("filter.way", filterWay), part("circles", &R::circles), part("two_point", &R::two_point),
        quantity<R>("harmonics", [](const R& r) { return harmonicRows(r.harmonics); }),
        quantity<R>("RONt_um", headlineDeviation_um, {LT_TEXT("Engine", "RONt"), unit::um}),
        quantity<R>("RONt_MZCI_um", circleDeviation<ReferenceCircle::MZCI>,
                    {LT_TEXT("Engine", "RONt(MZCI)"), unit::um, 3, false}),
        quantity<R>("RONt_LSCI_um", circleDeviation<ReferenceCircle::LSCI>,
                    {LT_TEXT("Engine", "RONt(LSCI)"), unit::um, 3, false}),
        quantity<R>("RONt_MICI_um", circleDeviation<ReferenceCircle::MICI>,
                    {LT_TEXT("Engine", "RONt(MICI)"), unit::um, 3, false}),
        quantity<R>("RONt_MCCI_um", circleDeviation<ReferenceCircle::MCCI>,
                    {LT_TEXT("Engine", "RONt(MCCI)"), unit::um, 3, false}),
        quantity<R>("reference_circle", [](const R& r) { return name(r.parameters.circle); }),
        quantity<R>("RONt_expanded_uncertainty_um", &R::RONt_expanded_uncertainty_um,
                    {LT_TEXT("Engine", "Expanded uncertainty (95 %)"), unit::um}),
        quantity<R>("point_noise_um", &R::point_noise_um,
                    {LT_TEXT("Engine", "Standard deviation of a point"), unit::um}),
        quantity<R>("tolerance_um", [](const R& r) { return r.parameters.tolerance_um; },
                    {LT_TEXT("Engine", "Tolerance"), unit::um, 3, false}),
        quantity<R>("decision_rule", [](const R& r) { return lathelier::key(r.parameters.decision); }),
        quantity<R>("verdict", verdictKey<R>), quantity<R>("methods", [](const R& r) { return listed(r.methods); }),
        quantity<R>("hints", [](const R& r) { return listed(r.hints); }), part("paper", &R::paper));
    return all;
}

const std::vector<QuantityOf<SuperimposeResult>>& quantitiesOf(const SuperimposeResult*)
{
    using R = SuperimposeResult;
    static const auto all = describedBy<R>(
        quantity<R>("largest_difference_um", &R::largest_difference_um,
                    {LT_TEXT("Engine", "Largest difference"), unit::um}),
        quantity<R>("mean_difference_um", &R::mean_difference_um, {LT_TEXT("Engine", "Mean difference"), unit::um}),
        quantity<R>("rms_difference_um", &R::rms_difference_um,
                    {LT_TEXT("Engine", "Root mean square difference"), unit::um}),
        quantity<R>("correlation", &R::correlation, {LT_TEXT("Engine", "Correlation of the forms"), {}, 4}),
        quantity<R>("rotation_deg", &R::rotation_deg, {LT_TEXT("Engine", "Turned by"), unit::deg}),
        quantity<R>("mirrored", &R::mirrored, {LT_TEXT("Engine", "Mirrored")}), quantity<R>("shift_mm", &R::shift_mm),
        quantity<R>("shift_x_mm", [](const R& r) { return r.shift_mm.x(); },
                    {LT_TEXT("Engine", "Shifted by, x"), unit::mm, 5, false}),
        quantity<R>("shift_y_mm", [](const R& r) { return r.shift_mm.y(); },
                    {LT_TEXT("Engine", "Shifted by, y"), unit::mm, 5, false}),
        quantity<R>("radius_difference_mm", &R::radius_difference_mm,
                    {LT_TEXT("Engine", "Radius larger by"), unit::mm, 5}),
        quantity<R>("angle_deg", &R::angle_deg), quantity<R>("first_um", &R::first_um),
        quantity<R>("second_um", &R::second_um));
    return all;
}

Rows harmonicRows(const std::vector<signal::Harmonic>& harmonics)
{
    Rows rows;
    for (const signal::Harmonic& h : harmonics)
        rows.rows.push_back({{{"upr", std::int64_t{h.upr}},
                              {"amplitude_um", h.amplitude},
                              {"phase_deg", h.phase_rad * 180 / std::numbers::pi}}});
    return rows;
}

Json toJson(const RoundnessResult& result)
{
    Json json = nestedJson(describedValues(result));
    json["notes"] = toJson(result.notes);
    return json;
}

Json toJson(const SuperimposeResult& result)
{
    Json json = nestedJson(describedValues(result));
    json["notes"] = toJson(result.notes);
    return json;
}

}  // namespace lathelier::form
