// Cylindricity: least-squares and minimum-zone cylinders.
// Source: ISO 12180-1.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/progress.h"
#include "engine/form/roundness/roundness.h"

namespace lathelier::form {

struct FittedCylinder {
    Eigen::Vector3d axis_point_mm = Eigen::Vector3d::Zero();    ///< on the axis, nearest to the points' centroid
    Eigen::Vector3d axis_direction = Eigen::Vector3d::UnitZ();  ///< toward + on its dominant coordinate
    double radius_mm = 0;                                       ///< MZCY: mean of inner and outer
    double inner_radius_mm = 0;                                 ///< smallest distance of a point from the axis
    double outer_radius_mm = 0;                                 ///< largest distance of a point from the axis
    double CYLt_um = 0;                                         ///< outer - inner radius
    double CYLp_um = std::numeric_limits<double>::quiet_NaN();  ///< outer radius - radius; LSCY only
    double CYLv_um = std::numeric_limits<double>::quiet_NaN();  ///< radius - inner radius; LSCY only
    double CYLq_um = std::numeric_limits<double>::quiet_NaN();  ///< root mean square of distance - radius; LSCY only
    std::vector<std::size_t> contacts;                          ///< indices of the contact points; MZCY only
};

struct CylindricityParameters {
    std::optional<double> tolerance_um;            ///< largest CYLt allowed; none: no verdict
    DecisionRule decision = DecisionRule::Simple;  ///< whether the uncertainty counts (ISO 14253-1)
    std::optional<double> probe_uncertainty_um;    ///< one standard deviation of a point; needed for the guarded
                                                   ///< decision; none: estimated from the points
};

const std::vector<Field<CylindricityParameters>>& fieldsOf(const CylindricityParameters*);

struct CylindricityResult {
    CylindricityParameters parameters;
    std::size_t points = 0;           ///< number of points given
    std::size_t points_left_out = 0;  ///< of them, those that were not measured (phantomPoints)
    FittedCylinder LSCY;              ///< least-squares cylinder
    FittedCylinder MZCY;              ///< minimum zone, locally optimal from several starts
    double axis_straightness_um = std::numeric_limits<double>::quiet_NaN();  ///< of the section centres, when the
                                                                             ///< points lie in sections z = const
    std::size_t sections = 0;  ///< planes z = const (or x, y: the axis' dominant coordinate) that the points lie in
    double length_mm = 0;      ///< of the points along the axis
    double point_noise_um = std::numeric_limits<double>::quiet_NaN();  ///< standard deviation of a point: stated, or
                                                                       ///< estimated; NaN: not known
    double CYLt_expanded_uncertainty_um = std::numeric_limits<double>::quiet_NaN();  ///< 95 %, of MZCY: Monte Carlo
    std::optional<Verdict> verdict;                                                  ///< of MZCY; with a tolerance
    Notes notes;  ///< phantomPoints; axisStraightnessUnknown, with fewer than 3 sections; with a verdict
                  ///< noiseEstimated, noiseNotKnown without U, failWithinUncertainty by simple acceptance
};

/// Whether the noise of the points is estimated where it is not stated. Left out, only a stated one gives U.
enum class NoiseEstimate { Made, LeftOut };

/// Whether `a` and `b` differ at most in the parameters of judge(): tolerance and decision rule.
bool sameButVerdict(const CylindricityParameters& a, const CylindricityParameters& b);

/// Replaces tolerance and decision rule of the result by those of `parameters` and decides again. Error
/// valueNotUnderstood (guarded without an uncertainty).
void judge(CylindricityResult& result, const CylindricityParameters& parameters);

/// Points of a cylindrical surface in any order and any pose. The verdict is MZCY's. Points that were not measured
/// (phantom_points.h) do not count.
/// Errors: tooFewPoints (6), pointsDegenerate (`found`: in one place, on a line, in a plane),
/// notConverged, coordinateTooLarge, valueNotUnderstood (guarded without an uncertainty). Throws Cancelled.
CylindricityResult cylindricity(std::span<const Eigen::Vector3d> points_mm,
                                const CylindricityParameters& parameters = {}, const Progress& progress = {},
                                NoiseEstimate noise = NoiseEstimate::Made);

}  // namespace lathelier::form
