// The part of a large cloud that lies near some places: for an index that serves a few queries.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

/// Spheres around places, within which points are needed.
struct Vicinity {
    std::vector<Eigen::Vector3d> places_mm;  ///< in the frame of the cloud
    double radius_mm = 0;                    ///< radius of each sphere
};

/// All points within the radius of any place of any vicinity, and some further ones, in the order given. All are
/// finite. Throws Cancelled.
std::vector<Eigen::Vector3d> pointsNear(const std::vector<Eigen::Vector3d>& points_mm,
                                        const std::vector<Vicinity>& vicinities, const Progress& progress = {});

/// About the distance between neighbours of a cloud that covers a surface: the root of its area for each point.
double roughSpacing_mm(const std::vector<Eigen::Vector3d>& points_mm, const Progress& progress = {});

}  // namespace lathelier::registration
