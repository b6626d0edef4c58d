#include "engine/registration/compare_quantities.h"

#include <nlohmann/json.hpp>

#include "engine/core/units.h"
#include "engine/registration/coarse_map.h"

namespace lathelier::registration {
namespace {

const char* methodKey(CompareMethod method)
{
    switch (method) {
        case CompareMethod::Auto: return "auto";
        case CompareMethod::Revolution: return "revolution";
        case CompareMethod::Plane: return "plane";
        case CompareMethod::Point: return "point";
    }
    return "";
}

std::vector<double> transformOf(const Alignment& alignment)
{
    using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
    const RowMajor matrix = alignment.reference_T_copy.matrix();
    return {matrix.data(), matrix.data() + matrix.size()};
}

/// The statistics within the result: signed quantities are not given for unsigned deviations.
std::vector<QuantityOf<CompareResult>> statisticsWithin()
{
    std::vector<QuantityOf<CompareResult>> result = included(&CompareResult::statistics);
    for (QuantityOf<CompareResult>& quantity : result)
        if (quantity.info.key.ends_with("_mm"))
            quantity.get = [get = quantity.get](const CompareResult& r) { return r.has_sign ? get(r) : Value(); };
    return result;
}

}  // namespace

const std::vector<QuantityOf<DeviationStatistics>>& quantitiesOf(const DeviationStatistics*)
{
    using S = DeviationStatistics;
    static const auto all = describedBy<S>(
        quantity<S>("overlap_percent", &S::overlap_percent,
                    {LT_TEXT("Engine", "Overlap (points of the copy that were used)"), unit::percent, 2}),
        quantity<S>("points_used", &S::points_used, {LT_TEXT("Engine", "Points used")}),
        quantity<S>("points_excluded", &S::points_excluded, {LT_TEXT("Engine", "Points left out")}),
        quantity<S>("rmse_mm", &S::rmse_mm, {LT_TEXT("Engine", "Root mean square"), unit::mm, 4}),
        quantity<S>("mean_mm", &S::mean_mm, {LT_TEXT("Engine", "Mean"), unit::mm, 4}),
        quantity<S>("std_mm", &S::std_mm, {LT_TEXT("Engine", "Standard deviation"), unit::mm, 4}),
        quantity<S>("min_mm", &S::min_mm, {LT_TEXT("Engine", "Smallest"), unit::mm, 4}),
        quantity<S>("max_mm", &S::max_mm, {LT_TEXT("Engine", "Largest"), unit::mm, 4}),
        quantity<S>("p95_abs_mm", &S::p95_abs_mm, {LT_TEXT("Engine", "95 % of the sizes lie below"), unit::mm, 4}),
        quantity<S>("median_mm", &S::median_mm, {LT_TEXT("Engine", "Median"), unit::mm, 4}),
        quantity<S>("mad_sigma_mm", &S::mad_sigma_mm,
                    {LT_TEXT("Engine", "Robust standard deviation (MAD)"), unit::mm, 4}),
        quantity<S>("p2_5_mm", &S::p2_5_mm, {LT_TEXT("Engine", "95 % of the points lie between"), unit::mm, 4}),
        quantity<S>("p97_5_mm", &S::p97_5_mm, {LT_TEXT("Engine", "… and"), unit::mm, 4}));
    return all;
}

const std::vector<QuantityOf<WorstPlace>>& quantitiesOf(const WorstPlace*)
{
    using W = WorstPlace;
    static const auto all = describedBy<W>(
        quantity<W>("z_mm", &W::z_mm, {LT_TEXT("Engine", "… along the axis at"), unit::mm, 2}),
        quantity<W>("point_mm", &W::point_mm),
        quantity<W>("angle_deg", &W::angle_deg, {LT_TEXT("Engine", "… at the angle"), unit::deg, 1}),
        quantity<W>("deviation_mm", &W::deviation_mm, {LT_TEXT("Engine", "Worst place: mean deviation"), unit::mm, 4}),
        quantity<W>("uncertainty_mm", &W::uncertainty_mm,
                    {LT_TEXT("Engine", "… its uncertainty (95 % for the worst of all places)"), unit::mm, 4}),
        quantity<W>("cell_mm", &W::cell_mm, {LT_TEXT("Engine", "… mean over a square of"), unit::mm, 2}));
    return all;
}

const std::vector<QuantityOf<Finding>>& quantitiesOf(const Finding*)
{
    using F = Finding;
    static const auto all =
        describedBy<F>(quantity<F>("kind", [](const F& f) { return key(f.kind); }),
                       quantity<F>("difference", [](const F& f) { return name(f.kind); },
                                   {LT_TEXT("Engine", "difference"), {}, 0, false}),
                       quantity<F>("z_start_mm", &F::z_start_mm, {LT_TEXT("Engine", "from"), unit::mm, 2}),
                       quantity<F>("z_end_mm", &F::z_end_mm, {LT_TEXT("Engine", "to"), unit::mm, 2}),
                       quantity<F>("value_mm", &F::value_mm, {LT_TEXT("Engine", "value"), unit::mm, 4}),
                       quantity<F>("uncertainty_mm", &F::uncertainty_mm, {LT_TEXT("Engine", "U"), unit::mm, 4}),
                       quantity<F>("limit_mm", &F::limit_mm, {LT_TEXT("Engine", "limit"), unit::mm, 4}),
                       quantity<F>("verdict", verdictKey<F>),
                       quantity<F>("judged", verdictName<F>, {LT_TEXT("Engine", "verdict"), {}, 0, false}));
    return all;
}

const std::vector<QuantityOf<Zone>>& quantitiesOf(const Zone*)
{
    using Z = Zone;
    static const auto all =
        describedBy<Z>(quantity<Z>("name", [](const Z& z) { return z.name.empty() ? Value() : Value(z.name); },
                                   {LT_TEXT("Engine", "name"), {}, 0}),
                       quantity<Z>("z_start_mm", &Z::z_start_mm, {LT_TEXT("Engine", "from"), unit::mm, 2}),
                       quantity<Z>("z_end_mm", &Z::z_end_mm, {LT_TEXT("Engine", "to"), unit::mm, 2}),
                       quantity<Z>("mean_mm", &Z::mean_mm, {LT_TEXT("Engine", "mean"), unit::mm, 4}),
                       quantity<Z>("std_mm", &Z::std_mm, {LT_TEXT("Engine", "std. dev."), unit::mm, 4}),
                       quantity<Z>("points", &Z::points, {LT_TEXT("Engine", "points"), {}, 0}),
                       quantity<Z>("uncertainty_mm", &Z::uncertainty_mm, {LT_TEXT("Engine", "U"), unit::mm, 4}),
                       quantity<Z>("verdict", verdictKey<Z>),
                       quantity<Z>("lower_mm", &Z::lower_mm, {LT_TEXT("Engine", "lower"), unit::mm, 4}),
                       quantity<Z>("upper_mm", &Z::upper_mm, {LT_TEXT("Engine", "upper"), unit::mm, 4}),
                       quantity<Z>("judged", verdictName<Z>, {LT_TEXT("Engine", "verdict"), {}, 0, false}));
    return all;
}

const std::vector<QuantityOf<FreeMotion>>& quantitiesOf(const FreeMotion*)
{
    using M = FreeMotion;
    const auto isRotation = [](const M& motion) { return motion.kind == M::Kind::Rotation; };
    const auto coordinate = [](const char* name, Eigen::Vector3d M::*vector, Eigen::Index i, const Look& look) {
        return quantity<M>(
            name, [vector, i](const M& motion) { return (motion.*vector)[i]; }, look);
    };
    static const auto all = describedBy<M>(
        quantity<M>("kind", [=](const M& motion) { return isRotation(motion) ? "rotation" : "translation"; }),
        quantity<M>("motion",
                    [=](const M& motion) {
                        return isRotation(motion) ? LT_TEXT("Engine", "rotation") : LT_TEXT("Engine", "translation");
                    },
                    {LT_TEXT("Engine", "motion"), {}, 0, false}),
        quantity<M>("direction", &M::direction), quantity<M>("point_mm", &M::point_mm),
        coordinate("direction_x", &M::direction, 0, {LT_TEXT("Engine", "direction x"), {}, 5, false}),
        coordinate("direction_y", &M::direction, 1, {LT_TEXT("Engine", "y"), {}, 5, false}),
        coordinate("direction_z", &M::direction, 2, {LT_TEXT("Engine", "z"), {}, 5, false}),
        coordinate("point_x_mm", &M::point_mm, 0, {LT_TEXT("Engine", "through x"), unit::mm, 3, false}),
        coordinate("point_y_mm", &M::point_mm, 1, {LT_TEXT("Engine", "y"), unit::mm, 3, false}),
        coordinate("point_z_mm", &M::point_mm, 2, {LT_TEXT("Engine", "z"), unit::mm, 3, false}));
    return all;
}

const std::vector<QuantityOf<Axis>>& quantitiesOf(const Axis*)
{
    static const auto all =
        describedBy<Axis>(quantity<Axis>("point_mm", &Axis::point_mm), quantity<Axis>("direction", &Axis::direction));
    return all;
}

const std::vector<QuantityOf<AlignmentUncertainty>>& quantitiesOf(const AlignmentUncertainty*)
{
    using U = AlignmentUncertainty;
    static const auto all = describedBy<U>(
        quantity<U>("axial_um", &U::axial_um, {LT_TEXT("Engine", "Uncertainty along the axis (k = 2)"), unit::um, 2}),
        quantity<U>("radial_um", &U::radial_um,
                    {LT_TEXT("Engine", "Uncertainty across the axis (k = 2)"), unit::um, 2}),
        quantity<U>("axis_deg", &U::axis_deg,
                    {LT_TEXT("Engine", "Uncertainty of the axis's direction (k = 2)"), unit::deg, 5}));
    return all;
}

const std::vector<QuantityOf<Alignment>>& quantitiesOf(const Alignment*)
{
    using A = Alignment;
    static const auto all = describedBy<A>(
        quantity<A>("transform_reference_from_copy", transformOf),
        quantity<A>("converged", &A::converged, {LT_TEXT("Engine", "Converged")}),
        quantity<A>("iterations", &A::iterations, {LT_TEXT("Engine", "Iterations")}), part("axis", &A::reference_axis),
        quantity<A>("free_motions", [](const A& a) { return listed(a.free_motions); }),
        part("uncertainty", &A::uncertainty));
    return all;
}

const std::vector<QuantityOf<Histogram>>& quantitiesOf(const Histogram*)
{
    static const auto all = describedBy<Histogram>(quantity<Histogram>("edges_mm", &Histogram::edges_mm),
                                                   quantity<Histogram>("counts", &Histogram::counts));
    return all;
}

const std::vector<QuantityOf<CompareResult>>& quantitiesOf(const CompareResult*)
{
    using C = CompareResult;
    using P = CompareParameters;
    const auto asked = [](auto P::*member) { return [member](const C& c) { return c.parameters.*member; }; };
    static const auto all = describedBy<C>(
        quantity<C>("method_used", [](const C& c) { return methodKey(c.method_used); }), included(&C::alignment),
        statisticsWithin(),
        quantity<C>("within_tolerance_percent", &C::within_tolerance_percent,
                    {LT_TEXT("Engine", "Share within tolerance"), unit::percent, 2}),
        quantity<C>("scatter_mm", &C::scatter_mm,
                    {LT_TEXT("Engine", "Noise of the points about the surface"), unit::mm, 4}),
        quantity<C>("verdict_rule", [](const C& c) { return key(c.parameters.verdict_rule); }),
        quantity<C>("decision_rule", [](const C& c) { return key(c.parameters.decision); }),
        quantity<C>("verdict", verdictKey<C>), part("worst", &C::worst),
        quantity<C>("findings", [](const C& c) { return listed(c.findings); }),
        quantity<C>("distinguishable_from_scanner", &C::distinguishable_from_scanner,
                    {LT_TEXT("Engine", "Difference told from the scanner's accuracy")}),
        quantity<C>("cloud_to_cloud_rmse_mm", &C::cloud_to_cloud_rmse_mm,
                    {LT_TEXT("Engine", "Cloud-to-cloud RMSE"), unit::mm, 4}),
        quantity<C>("cloud_to_cloud_rmse_standard_error_mm", &C::cloud_to_cloud_rmse_error_mm),
        quantity<C>("sampling_floor_mm", &C::sampling_floor_mm,
                    {LT_TEXT("Engine", "Its floor: what sampling alone gives"), unit::mm, 4}),
        quantity<C>("zones", [](const C& c) { return listed(c.zones); }),
        part("histogram", &C::histogram),  // In tables beside the results; JSON has them under "parameters".
        quantity<C>("tolerance_mm", asked(&P::tolerance_mm),
                    {LT_TEXT("Engine", "Tolerance, plus and minus"), unit::mm, 3, false}),
        quantity<C>("pass_percent", asked(&P::pass_percent),
                    {LT_TEXT("Engine", "Share needed to pass"), unit::percent, 2, false}),
        quantity<C>("scanner_accuracy_mm", asked(&P::scanner_accuracy_mm),
                    {LT_TEXT("Engine", "Scanner's accuracy"), unit::mm, 3, false}));
    return all;
}

Json toJson(const CompareResult& result)
{
    Json json = nestedJson(describedValues(result));
    json["map"] = result.unrolled ? nestedJson(describedValues(coarseOf(*result.unrolled))) : Json(nullptr);
    return json;
}

}  // namespace lathelier::registration
