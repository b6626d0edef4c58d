// Form differences in workshop terms: steps, tapers, barrels, bumps, missing stretches.
#pragma once

#include <vector>

#include "engine/registration/verdict/surface_verdict.h"

namespace lathelier::registration {

/// The significant differences, ordered by their value relative to the limit; at most eight.
/// A taper and a barrel are judged by the width of the tolerance band, all others by the limit on their side. Where the
/// deviation has no sign there are none but missing stretches. `factor`: SurfaceVerdict::factor, for bumps.
std::vector<Finding> findDifferences(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule,
                                     double factor);

/// Standard uncertainty of the mean deviation over a stretch of the axis with so many points, all round.
double meanSigma_mm(const SurfaceWindows& all, double z_start_mm, double z_end_mm, double points,
                    const Eigen::Vector3d& mean_normal);

/// Mean of the surface's normals over a stretch of the axis, weighted by points: nearly parallel to the axis or zero
/// where the copy is seen from all sides.
Eigen::Vector3d meanNormal(const SurfaceWindows& all, double z_start_mm, double z_end_mm);

}  // namespace lathelier::registration
