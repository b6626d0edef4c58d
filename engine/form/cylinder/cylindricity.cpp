#include "engine/form/cylinder/cylindricity.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/form/cylinder/cylinder_least_squares.h"
#include "engine/form/cylinder/cylinder_sections.h"
#include "engine/form/cylinder/cylinder_uncertainty.h"
#include "engine/form/cylinder/cylinder_zone.h"
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
    std::erase_if(result.notes, [](const Note& note) { return note.code == notes::noiseNotKnown; });
    if (result.verdict && !parameters.probe_uncertainty_um) result.notes.push_back({notes::noiseNotKnown, {}});
}

CylindricityResult cylindricity(std::span<const Vector3d> points_mm, const CylindricityParameters& parameters,
                                const Progress& progress)
{
    refuseUnfounded(parameters);
    CylindricityResult result;
    result.parameters = parameters;
    result.points = points_mm.size();
    progress.report(0);
    const CylinderGuess guess = guessCylinder(points_mm, progress);
    progress.report(0.1);

    const CylinderPoints points(points_mm, guess.mean_mm, guess.direction, guess.scale_mm);
    const LeastSquaresCylinder fit = leastSquaresCylinder(points, guess.cylinder, progress);
    if (!fit.converged) throw Error(errors::notConverged, {{"iterations", std::int64_t{200}}});
    result.LSCY = toCylinder(points, fit, progress);
    progress.report(0.3);
    const MinimumZoneCylinder zone = minimumZoneCylinder(points, fit.axis, progress.part(0.3, 0.9));
    result.MZCY = toCylinder(points, zone);
    if (parameters.probe_uncertainty_um)
        result.CYLt_expanded_uncertainty_um =
            points.scale_mm() * um_per_mm *
            expandedUncertaintyOfWidth(points, fit, *parameters.probe_uncertainty_um / um_per_mm / points.scale_mm(),
                                       progress.part(0.9, 1));
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
