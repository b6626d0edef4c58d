// How densely a cloud samples its surface.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier {

class Neighbours;

/// Root mean square distance from a random place of the surface to the nearest sample, √((a² + b²)/12) for a grid of
/// a × b: what the cloud-to-cloud RMSE of identical, noiseless parts amounts to. a is the median distance to the
/// nearest sample, a·b the median area of a sample, both in the tangent plane at some hundred places. NaN with fewer
/// than 200 points. `index` is of the same points.
double samplingFloor_mm(const std::vector<Eigen::Vector3d>& points, const Neighbours& index,
                        const Progress& progress = {});

}  // namespace lathelier
