#include "engine/deflection/triage.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/measured_places.h"

namespace lathelier::deflection {
namespace {

constexpr double clearShare = 0.5;  ///< largest share of the residual of the next best cause

}  // namespace

const char* key(ErrorCause cause)
{
    switch (cause) {
        case ErrorCause::Program: return "program";
        case ErrorCause::Alignment: return "alignment";
        case ErrorCause::Deflection: return "deflection";
        case ErrorCause::Undecided: break;
    }
    return "undecided";
}

Text nameOf(ErrorCause cause)
{
    switch (cause) {
        case ErrorCause::Program: return LT_TEXT("Engine", "an offset: program or tool");
        case ErrorCause::Alignment: return LT_TEXT("Engine", "a taper: tailstock or headstock out of line");
        case ErrorCause::Deflection: return LT_TEXT("Engine", "the work gives way");
        case ErrorCause::Undecided: break;
    }
    return LT_TEXT("Engine", "undecided");
}

TriageResult triage(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                    std::span<const MeasuredDiameter> measured)
{
    const auto count = static_cast<Eigen::Index>(measured.size());
    if (count < 2)
        throw Error(errors::tooFewMeasured,
                    {{"found", static_cast<std::int64_t>(count)}, {"parameters", std::int64_t{2}}});
    const WorkPlan plan = workPlan(stock, runs, setup);
    const FinalContour contour = finalContour(plan, setup);
    if (contour.z_mm.empty()) throw Error(errors::noCut, {});
    const MeasuredPlaces places(contour, measured);
    const Eigen::VectorXd targets_mm = places.of(contour.target_radius_mm);
    Eigen::MatrixXd shapes(count, 3);
    Eigen::VectorXd found_um(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const MeasuredDiameter& one = measured[static_cast<std::size_t>(i)];
        found_um(i) = um_per_mm * (one.diameter_mm - 2 * targets_mm(i));
        shapes(i, 0) = 1;
        shapes(i, 1) = 1 - one.z_mm / plan.length_mm();
    }
    shapes.col(2) = places.of(contour.diameter_error_um);
    const auto rms = [count](const Eigen::VectorXd& v) {
        return std::sqrt(v.squaredNorm() / static_cast<double>(count));
    };
    TriageResult result;
    result.rms_um = rms(found_um);
    for (Eigen::Index k = 0; k < 3; ++k) {
        const double square = shapes.col(k).squaredNorm();
        const double size = square > 0 ? shapes.col(k).dot(found_um) / square : 0;
        result.alone.push_back({static_cast<ErrorCause>(k), size, rms(found_um - size * shapes.col(k))});
    }
    std::vector<CauseFit> ordered = result.alone;
    std::sort(ordered.begin(), ordered.end(), [](const CauseFit& a, const CauseFit& b) { return a.rms_um < b.rms_um; });
    if (ordered[0].rms_um < clearShare * ordered[1].rms_um) result.cause = ordered[0].cause;
    if (count >= 4) {
        const Eigen::Vector3d sizes = shapes.colPivHouseholderQr().solve(found_um);
        result.offset_um = sizes(0);
        result.taper_um = sizes(1);
        result.scale = sizes(2);
    }
    return result;
}

}  // namespace lathelier::deflection
