// Distance from each point of one cloud to the nearest point of another: the paper's cloud-to-cloud comparison.
// Source: Miądlicki et al., "Remanufacturing System with Chatter Suppression for CNC Turning", section 3.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

class Neighbours;

/// For each query point the distance in mm to the nearest reference point, computed in double precision and exact but
/// for the last rounding; NaN where there is none within `max_distance_mm` (inclusive) and for a query that is not
/// finite. Reference points are finite. Any distribution of points is fine. Throws Cancelled.
std::vector<float> nearestDistances(const std::vector<Eigen::Vector3d>& reference_mm,
                                    const std::vector<Eigen::Vector3d>& query_mm, double max_distance_mm,
                                    const Progress& progress = {});
std::vector<float> nearestDistances(const Neighbours& reference, const std::vector<Eigen::Vector3d>& query_mm,
                                    double max_distance_mm, const Progress& progress = {});

}  // namespace lathelier::registration
