// How densely a cloud samples its surface.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

class Neighbours;

struct SamplingFloor {
    double rms_mm = std::numeric_limits<double>::quiet_NaN();  ///< NaN with fewer than 200 points
    double reach_mm = 0;                                       ///< largest distance between a place and its neighbours
};

/// The places of a cloud that samplingFloor() looks at, and how many of their neighbours.
std::vector<Eigen::Vector3d> samplingPlaces(const std::vector<Eigen::Vector3d>& points_mm);
std::size_t samplingNeighbours(std::size_t points);

/// Root mean square distance from a random place of the surface to the nearest sample, √((a² + b²)/12) for a grid of
/// a × b: the cloud-to-cloud RMSE of identical, noiseless parts. a is the median distance to the
/// nearest sample, a·b the median area of a sample, both in the tangent plane at some hundred places. `index` is of
/// the points, or of those near the places.
SamplingFloor samplingFloor(const std::vector<Eigen::Vector3d>& points_mm, const Neighbours& index,
                            const Progress& progress = {});

}  // namespace lathelier::registration
