#include "engine/deflection/deflection_quantities.h"

#include "engine/core/units.h"

namespace lathelier::deflection {
namespace {

}  // namespace

const std::vector<QuantityOf<PassResult>>& quantitiesOf(const PassResult*)
{
    using R = PassResult;
    static const auto all = describedBy<R>(
        quantity<R>("line", &R::line), quantity<R>("z_mm", &R::z_mm), quantity<R>("x_mm", &R::x_mm),
        quantity<R>("radius_mm", &R::radius_mm), quantity<R>("diameter_error_um", &R::diameter_error_um),
        quantity<R>("F_t_N", &R::F_t_N), quantity<R>("F_f_N", &R::F_f_N), quantity<R>("F_ap_N", &R::F_ap_N),
        quantity<R>("depth_mm", &R::depth_mm), quantity<R>("deflection_x_um", &R::dx_um),
        quantity<R>("deflection_y_um", &R::dy_um), quantity<R>("stiffness_N_mm", &R::stiffness_N_mm));
    return all;
}

const std::vector<QuantityOf<FinalContour>>& quantitiesOf(const FinalContour*)
{
    using R = FinalContour;
    static const auto all = describedBy<R>(
        quantity<R>("z_mm", &R::z_mm), quantity<R>("target_radius_mm", &R::target_radius_mm),
        quantity<R>("radius_mm", &R::radius_mm), quantity<R>("diameter_error_um", &R::diameter_error_um));
    return all;
}

const std::vector<QuantityOf<ErrorSummary>>& quantitiesOf(const ErrorSummary*)
{
    using R = ErrorSummary;
    static const auto all = describedBy<R>(
        quantity<R>("max_um", &R::max_um, {LT_TEXT("Engine", "Largest diameter error"), unit::um, 2}),
        quantity<R>("mean_abs_um", &R::mean_abs_um,
                    {LT_TEXT("Engine", "Mean size of the diameter error"), unit::um, 2}),
        quantity<R>("range_um", &R::range_um, {LT_TEXT("Engine", "Range of the diameter error"), unit::um, 2}),
        quantity<R>("wear_offset_um", &R::wear_offset_um,
                    {LT_TEXT("Engine", "Offset of X on diameter that leaves least"), unit::um, 2}));
    return all;
}

const std::vector<QuantityOf<DeflectionResult>>& quantitiesOf(const DeflectionResult*)
{
    using R = DeflectionResult;
    static const auto all = describedBy<R>(
        quantity<R>("passes", [](const R& r) { return listed(r.passes); }), part("final", &R::final),
        included(&R::summary),
        quantity<R>("length_mm", &R::length_mm, {LT_TEXT("Engine", "Length of the stock"), unit::mm, 2}));
    return all;
}

const std::vector<QuantityOf<CorrectedNode>>& quantitiesOf(const CorrectedNode*)
{
    using R = CorrectedNode;
    static const auto all = describedBy<R>(
        quantity<R>("line", &R::line, {LT_TEXT("Engine", "Line"), {}, 0}),
        quantity<R>("added", &R::added, {LT_TEXT("Engine", "Added"), {}, 0}),
        quantity<R>("z_mm", &R::z_mm, {LT_TEXT("Engine", "z"), unit::mm, 3}),
        quantity<R>("x_mm", &R::x_mm, {LT_TEXT("Engine", "Radius to program"), unit::mm, 4}),
        quantity<R>("programmed_mm", &R::programmed_mm, {LT_TEXT("Engine", "Radius programmed"), unit::mm, 4}),
        quantity<R>("correction_um", &R::correction_um, {LT_TEXT("Engine", "Correction on diameter"), unit::um, 1}),
        quantity<R>("deflection_x_um", &R::dx_um, {LT_TEXT("Engine", "Deflection toward the tool"), unit::um, 2}),
        quantity<R>("deflection_y_um", &R::dy_um,
                    {LT_TEXT("Engine", "Deflection along the cutting speed"), unit::um, 2}),
        quantity<R>("F_t_N", &R::F_t_N, {LT_TEXT("Engine", "F_t"), unit::newton, 1}),
        quantity<R>("F_f_N", &R::F_f_N, {LT_TEXT("Engine", "F_f"), unit::newton, 1}),
        quantity<R>("F_ap_N", &R::F_ap_N, {LT_TEXT("Engine", "F_ap"), unit::newton, 1}),
        quantity<R>("stiffness_N_mm", &R::stiffness_N_mm, {LT_TEXT("Engine", "Stiffness at the tool"), unit::N_mm, 0}));
    return all;
}

const std::vector<QuantityOf<RobustnessRow>>& quantitiesOf(const RobustnessRow*)
{
    using R = RobustnessRow;
    static const auto all = describedBy<R>(
        quantity<R>("plant", &R::key),
        quantity<R>("plant_name", [](const R& r) { return r.name; },
                    {LT_TEXT("Engine", "Machine and work"), {}, 0, false}),
        quantity<R>("mean_abs_before_um", &R::mean_abs_before_um,
                    {LT_TEXT("Engine", "Mean error before"), unit::um, 2}),
        quantity<R>("mean_abs_after_um", &R::mean_abs_after_um, {LT_TEXT("Engine", "Mean error after"), unit::um, 2}),
        quantity<R>("max_after_um", &R::max_after_um, {LT_TEXT("Engine", "Largest error after"), unit::um, 2}),
        quantity<R>("reduction_percent", &R::reduction_percent, {LT_TEXT("Engine", "Reduction"), unit::percent, 0}));
    return all;
}

const std::vector<QuantityOf<CompensationResult>>& quantitiesOf(const CompensationResult*)
{
    using R = CompensationResult;
    static const auto all =
        describedBy<R>(quantity<R>("blocks_changed", &R::blocks_changed, {LT_TEXT("Engine", "Blocks changed"), {}, 0}),
                       quantity<R>("blocks_added", &R::blocks_added, {LT_TEXT("Engine", "Blocks added"), {}, 0}),
                       quantity<R>("largest_correction_um", &R::largest_correction_um,
                                   {LT_TEXT("Engine", "Largest correction on diameter"), unit::um, 1}),
                       quantity<R>("residual_max_um", [](const R& r) { return r.residual.max_um; },
                                   {LT_TEXT("Engine", "Largest error of the written program"), unit::um, 2}),
                       quantity<R>("residual_mean_abs_um", [](const R& r) { return r.residual.mean_abs_um; },
                                   {LT_TEXT("Engine", "Mean error of the written program"), unit::um, 2}),
                       quantity<R>("nodes",
                                   [](const R& r) {
                                       Rows rows;
                                       for (const CorrectedRun& run : r.runs)
                                           for (const Row& row : listed(run.nodes).rows) rows.rows.push_back(row);
                                       return rows;
                                   }),
                       quantity<R>("robustness", [](const R& r) { return listed(r.robustness); }));
    return all;
}

const std::vector<QuantityOf<IdentifiedFactor>>& quantitiesOf(const IdentifiedFactor*)
{
    using R = IdentifiedFactor;
    static const auto all =
        describedBy<R>(quantity<R>("parameter", [](const R& r) { return nameOf(r.influence).key; }),
                       quantity<R>("parameter_name", [](const R& r) { return nameOf(r.influence).name; },
                                   {LT_TEXT("Engine", "Parameter"), {}, 0, false}),
                       quantity<R>("factor", &R::factor, {LT_TEXT("Engine", "Factor"), {}, 3}),
                       quantity<R>("value", &R::value, {LT_TEXT("Engine", "Value"), {}, 3}),
                       quantity<R>("uncertainty_percent", &R::uncertainty_percent,
                                   {LT_TEXT("Engine", "Standard uncertainty"), unit::percent, 1}));
    return all;
}

const std::vector<QuantityOf<ComparedDiameter>>& quantitiesOf(const ComparedDiameter*)
{
    using R = ComparedDiameter;
    static const auto all =
        describedBy<R>(quantity<R>("z_mm", &R::z_mm, {LT_TEXT("Engine", "z"), unit::mm, 2}),
                       quantity<R>("measured_um", &R::measured_um, {LT_TEXT("Engine", "Measured error"), unit::um, 2}),
                       quantity<R>("before_um", &R::before_um, {LT_TEXT("Engine", "Predicted before"), unit::um, 2}),
                       quantity<R>("after_um", &R::after_um, {LT_TEXT("Engine", "Predicted after"), unit::um, 2}),
                       quantity<R>("uncertainty_um", &R::uncertainty_um,
                                   {LT_TEXT("Engine", "Uncertainty of the prediction"), unit::um, 2}),
                       quantity<R>("E_n", &R::E_n, {LT_TEXT("Engine", "E_n"), {}, 2}));
    return all;
}

const std::vector<QuantityOf<IdentificationResult>>& quantitiesOf(const IdentificationResult*)
{
    using R = IdentificationResult;
    static const auto all = describedBy<R>(
        quantity<R>("factors", [](const R& r) { return listed(r.factors); }),
        quantity<R>("correlation", &R::correlation),
        quantity<R>("diameters", [](const R& r) { return listed(r.diameters); }),
        quantity<R>("rms_before_um", &R::rms_before_um, {LT_TEXT("Engine", "Left before (rms)"), unit::um, 2}),
        quantity<R>("rms_after_um", &R::rms_after_um, {LT_TEXT("Engine", "Left after (rms)"), unit::um, 2}),
        quantity<R>("iterations", &R::iterations));
    return all;
}

const std::vector<QuantityOf<FeedResult>>& quantitiesOf(const FeedResult*)
{
    using R = FeedResult;
    static const auto all = describedBy<R>(
        quantity<R>("z_mm", &R::z_mm), quantity<R>("feed_mm_rev", &R::feed_mm_rev),
        quantity<R>("diameter_error_um", &R::diameter_error_um),
        quantity<R>("max_um", &R::max_um, {LT_TEXT("Engine", "Largest error with these feeds"), unit::um, 2}),
        quantity<R>("time_ratio", &R::time_ratio, {LT_TEXT("Engine", "Time by that of the program"), {}, 3}));
    return all;
}

const std::vector<QuantityOf<Sensitivity>>& quantitiesOf(const Sensitivity*)
{
    using R = Sensitivity;
    static const auto all = describedBy<R>(
        quantity<R>("influence", &R::key),
        quantity<R>("influence_name", [](const R& r) { return r.name; },
                    {LT_TEXT("Engine", "Influence"), {}, 0, false}),
        quantity<R>("max_um_minus", &R::max_um_minus, {LT_TEXT("Engine", "Largest error at -10 %"), unit::um, 2}),
        quantity<R>("max_um_plus", &R::max_um_plus, {LT_TEXT("Engine", "Largest error at +10 %"), unit::um, 2}),
        quantity<R>("mean_abs_um_minus", &R::mean_abs_um_minus,
                    {LT_TEXT("Engine", "Mean error at -10 %"), unit::um, 2}),
        quantity<R>("mean_abs_um_plus", &R::mean_abs_um_plus, {LT_TEXT("Engine", "Mean error at +10 %"), unit::um, 2}));
    return all;
}

const std::vector<QuantityOf<ErrorBand>>& quantitiesOf(const ErrorBand*)
{
    using R = ErrorBand;
    static const auto all = describedBy<R>(
        quantity<R>("z_mm", &R::z_mm), quantity<R>("low_um", &R::low_um), quantity<R>("high_um", &R::high_um),
        quantity<R>("max_low_um", &R::max_low_um, {LT_TEXT("Engine", "Largest error, least of 95 %"), unit::um, 1}),
        quantity<R>("max_high_um", &R::max_high_um, {LT_TEXT("Engine", "Largest error, most of 95 %"), unit::um, 1}),
        quantity<R>("samples_used", &R::samples_used, {LT_TEXT("Engine", "Samples"), {}, 0}));
    return all;
}

const std::vector<QuantityOf<CauseFit>>& quantitiesOf(const CauseFit*)
{
    using R = CauseFit;
    static const auto all =
        describedBy<R>(quantity<R>("cause", [](const R& r) { return key(r.cause); }),
                       quantity<R>("cause_name", [](const R& r) { return nameOf(r.cause); },
                                   {LT_TEXT("Engine", "Cause"), {}, 0, false}),
                       quantity<R>("size", &R::size, {LT_TEXT("Engine", "Size"), {}, 2}),
                       quantity<R>("rms_um", &R::rms_um, {LT_TEXT("Engine", "Leaves (rms)"), unit::um, 2}));
    return all;
}

const std::vector<QuantityOf<TriageResult>>& quantitiesOf(const TriageResult*)
{
    using R = TriageResult;
    static const auto all = describedBy<R>(
        quantity<R>("cause", [](const R& r) { return key(r.cause); }),
        quantity<R>("causes", [](const R& r) { return listed(r.alone); }),
        quantity<R>("rms_um", &R::rms_um, {LT_TEXT("Engine", "Measured errors (rms)"), unit::um, 2}),
        quantity<R>("offset_um", &R::offset_um, {LT_TEXT("Engine", "Offset"), unit::um, 2}),
        quantity<R>("taper_um", &R::taper_um, {LT_TEXT("Engine", "Taper at the free end"), unit::um, 2}),
        quantity<R>("deflection_scale", &R::scale, {LT_TEXT("Engine", "Factor on the deflection"), {}, 3}));
    return all;
}

}  // namespace lathelier::deflection
