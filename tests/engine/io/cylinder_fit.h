// A small geometric least-squares cylinder, to check that a cloud was read correctly.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace lathelier::testing {

/// Diameter of the cylinder whose squared distances to the points have the smallest sum.
double cylinderDiameter(const std::vector<Eigen::Vector3d>& points);

}  // namespace lathelier::testing
