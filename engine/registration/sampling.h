// How densely a cloud samples its surface.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "engine/core/progress.h"

namespace lathelier {

/// Root mean square distance from a random place of the surface to the nearest sample, √((a² + b²)/12) for a grid of
/// a × b: what the cloud-to-cloud RMSE of identical, noiseless parts amounts to. a is the median distance to the
/// nearest sample, a·b the median area of a sample, both in the tangent plane at a few dozen places. NaN with fewer
/// than 200 points.
double samplingFloor_mm(const std::vector<Eigen::Vector3d>& points, const Progress& progress = {});

}  // namespace lathelier
