// Planes across and along an axis in a group of points: how much of the group they hold.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace lathelier::features {

/// Share of the points in planes that hold at least `least_share` of them each and whose normals are along the axis (z)
/// or across it. Planes are found one after the other, that with the most points first.
double planesShare(const std::vector<Eigen::Vector3d>& on_axis, double least_share, double sigma_mm);

}  // namespace lathelier::features
