// Mean and principal axes of points, and the check for degenerate points.
#pragma once

#include <Eigen/Core>
#include <span>

#include "engine/core/progress.h"

namespace lathelier {

struct PointSpread {
    Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();   ///< columns: principal axes, the longest last
    Eigen::Vector3d extent_mm = Eigen::Vector3d::Zero();  ///< root mean square along them
    double largest_mm = 0;                                ///< largest coordinate
};

/// Errors: tooFewPoints (fewer than `least`), coordinateTooLarge (beyond `limit_mm` or not finite).
PointSpread spreadOf(std::span<const Eigen::Vector3d> points_mm, std::size_t least, double limit_mm,
                     const Progress& progress = {});

/// Error pointsDegenerate when the extent is no more than `place_mm` (in one place), or across it than `flat_mm` (on a
/// line, in a plane).
void refuseDegenerate(const PointSpread& spread, double place_mm, double flat_mm);

}  // namespace lathelier
