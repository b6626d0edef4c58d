// Clusters of stray points: clouds that fill space, in the air or inside the part, also some that touch its surface.
//
// A surface is a sheet: within a cube the standard deviation across it is that of the noise, and within the size of the
// cube along it. The points of a cluster have the same order of scatter in all directions, and their density is highest
// in the middle, which distinguishes it from a corner of several sheets and from a tube.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::features {

struct LooseCluster {
    Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Identity();  ///< of the covariance of its points
    double reach_mm = 0;                                    ///< no point of it is further from the middle
    double points = 0;                                      ///< within three standard deviations
    bool thin = false;                                      ///< found in coarse cubes only

    /// Does the point lie in it, within so many standard deviations?
    bool contains(const Eigen::Vector3d& point, double sigmas) const
    {
        const Eigen::Vector3d off = point - middle_mm;
        return off.dot(inverse * off) < sigmas * sigmas;
    }
};

/// Clusters among points that lie on no seen surface. `sigma_mm`: noise of points of a surface.
std::vector<LooseCluster> findClusters(const std::vector<Eigen::Vector3d>& points, double sigma_mm,
                                       const Progress& progress = {});

}  // namespace lathelier::features
