#include "engine/form/cylinder/cylindricity.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/form/cylinder/cylinder_least_squares.h"
#include "engine/form/cylinder/cylinder_sections.h"
#include "engine/form/cylinder/cylinder_uncertainty.h"
#include "engine/form/cylinder/cylinder_zone.h"
#include "engine/form/cylinder/phantom_points.h"
#include "engine/form/cylinder/straightness.h"
#include "engine/form/form_codes.h"

namespace lathelier::form {
namespace {

using Eigen::Vector3d;

constexpr std::size_t leastSections = 3;  // fewer section centres define no straightness

FittedCylinder placed(const CylinderPoints& points, const AxisParameters& axis)
{
    FittedCylinder cylinder;
    cylinder.axis_point_mm = points.pointOf(axis);
    cylinder.axis_direction = towardPositive(points.directionOf(axis));
    return cylinder;
}

FittedCylinder toCylinder(const CylinderPoints& points, const LeastSquaresCylinder& fit, const Progress& progress)
{
    FittedCylinder cylinder = placed(points, fit.axis);
    const CylinderPoints::Extremes e = points.extremes(fit.axis, progress);
    const double scale = points.scale_mm();
    cylinder.radius_mm = fit.radius * scale;
    cylinder.inner_radius_mm = e.nearest * scale;
    cylinder.outer_radius_mm = e.farthest * scale;
    cylinder.CYLt_um = e.width() * scale * um_per_mm;
    cylinder.CYLp_um = (e.farthest - fit.radius) * scale * um_per_mm;
    cylinder.CYLv_um = (fit.radius - e.nearest) * scale * um_per_mm;
    cylinder.CYLq_um = fit.rms * scale * um_per_mm;
    return cylinder;
}

FittedCylinder toCylinder(const CylinderPoints& points, const MinimumZoneCylinder& fit)
{
    FittedCylinder cylinder = placed(points, fit.axis);
    const double scale = points.scale_mm();
    cylinder.radius_mm = 0.5 * (fit.inner + fit.outer) * scale;
    cylinder.inner_radius_mm = fit.inner * scale;
    cylinder.outer_radius_mm = fit.outer * scale;
    cylinder.CYLt_um = (fit.outer - fit.inner) * scale * um_per_mm;
    cylinder.contacts = fit.contacts;
    return cylinder;
}

/// To 0.001 µm, for messages.
double rounded(double value_um)
{
    return std::round(1000 * value_um) / 1000;
}

/// Guarded acceptance requires an uncertainty.
void refuseUnfounded(const CylindricityParameters& parameters)
{
    if (parameters.tolerance_um && parameters.decision == DecisionRule::Guarded && !parameters.probe_uncertainty_um)
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", "probe_uncertainty_um"},
                     {"found", Value()},
                     {"expected", LT_TEXT("Engine", "a value, for a decision with uncertainty")}});
}

}  // namespace

bool sameButVerdict(const CylindricityParameters& a, const CylindricityParameters& b)
{
    return a.probe_uncertainty_um == b.probe_uncertainty_um;
}

void judge(CylindricityResult& result, const CylindricityParameters& parameters)
{
    refuseUnfounded(parameters);
    result.parameters = parameters;
    result.verdict = parameters.tolerance_um
                         ? std::optional(lathelier::judge(result.MZCY.CYLt_um, result.CYLt_expanded_uncertainty_um,
                                                          *parameters.tolerance_um, parameters.decision))
                         : std::nullopt;
    std::erase_if(result.notes, [](const Note& note) {
        return note.code == notes::noiseNotKnown || note.code == notes::noiseEstimated ||
               note.code == notes::failWithinUncertainty;
    });
    if (!result.verdict) return;
    if (std::isnan(result.point_noise_um))
        result.notes.push_back({notes::noiseNotKnown, {}});
    else if (!parameters.probe_uncertainty_um)
        result.notes.push_back({notes::noiseEstimated, {{"sigma_um", rounded(result.point_noise_um)}}});
    const double value_um = result.MZCY.CYLt_um, uncertainty_um = result.CYLt_expanded_uncertainty_um;
    if (parameters.decision == DecisionRule::Simple && result.verdict == Verdict::Fail &&
        value_um - uncertainty_um <= *parameters.tolerance_um)
        result.notes.push_back({notes::failWithinUncertainty,
                                {{"value_um", rounded(value_um)},
                                 {"limit_um", *parameters.tolerance_um},
                                 {"uncertainty_um", rounded(uncertainty_um)}}});
}

CylindricityResult cylindricity(std::span<const Vector3d> points_mm, const CylindricityParameters& parameters,
                                const Progress& progress, NoiseEstimate noise)
{
    refuseUnfounded(parameters);
    CylindricityResult result;
    result.parameters = parameters;
    result.points = points_mm.size();
    progress.report(0);
    const std::vector<std::size_t> kept = withoutPhantoms(points_mm, result.notes, progress);
    std::vector<Vector3d> measured;
    if (!kept.empty()) {
        result.points_left_out = points_mm.size() - kept.size();
        measured.reserve(kept.size());
        for (const std::size_t index : kept) measured.push_back(points_mm[index]);
        points_mm = measured;
    }
    const CylinderGuess guess = guessCylinder(points_mm, progress);
    progress.report(0.1);

    const CylinderPoints points(points_mm, guess.mean_mm, guess.direction, guess.scale_mm);
    const LeastSquaresCylinder fit = leastSquaresCylinder(points, guess.cylinder, progress);
    if (!fit.converged) throw Error(errors::notConverged, {{"iterations", std::int64_t{200}}});
    result.LSCY = toCylinder(points, fit, progress);
    progress.report(0.3);
    const MinimumZoneCylinder zone = minimumZoneCylinder(points, fit.axis, progress.part(0.3, 0.9));
    result.MZCY = toCylinder(points, zone);
    if (!kept.empty())
        for (std::size_t& contact : result.MZCY.contacts) contact = kept[contact];
    const double um_per_unit = points.scale_mm() * um_per_mm;
    if (parameters.probe_uncertainty_um)
        result.point_noise_um = *parameters.probe_uncertainty_um;
    else if (noise == NoiseEstimate::Made)
        result.point_noise_um = um_per_unit * estimatedNoise(points, fit, progress);
    if (!std::isnan(result.point_noise_um))
        result.CYLt_expanded_uncertainty_um =
            um_per_unit *
            expandedUncertaintyOfWidth(points, fit, result.point_noise_um / um_per_unit, progress.part(0.9, 1));
    judge(result, parameters);

    const SectionStack stack =
        sectionsAlong(points_mm, result.LSCY.axis_point_mm, result.LSCY.axis_direction, progress);
    result.length_mm = stack.length_mm;
    result.sections = stack.centres_mm.size();
    if (result.sections >= leastSections)
        result.axis_straightness_um = straightness(stack.centres_mm).axis_straightness_um;
    else
        result.notes.push_back(
            {notes::axisStraightnessUnknown,
             {{"reason", result.sections == 0 ? LT_TEXT("Engine", "the points do not lie in sections across the axis")
                                              : LT_TEXT("Engine", "there are too few sections")},
              {"sections", static_cast<std::int64_t>(result.sections)},
              {"minimum", static_cast<std::int64_t>(leastSections)}}});
    progress.report(1);
    return result;
}

}  // namespace lathelier::form
