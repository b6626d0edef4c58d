// How far from the reference a point of the copy may lie and still count, where nobody says so.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace lathelier::registration {

/// Twice the distance within which nine tenths of the points lie from the middle (the median of each coordinate):
/// spurious points hardly change it. At least one point, all finite.
double robustSize_mm(const std::vector<Eigen::Vector3d>& points_mm);

/// 0.6 % of the part's size (1 mm on a shaft of 183 mm), never less than 10 standard deviations of the noise. Points
/// that scatter by more than 1 % of the size lie on no surface: that is no noise. `scatter`, the standard deviation of
/// what was found, may hold a misfit as well: ten of it count up to 2 % of the size only.
double defaultReach_mm(double size_mm, double noise_mm, double scatter_mm = 0);

}  // namespace lathelier::registration
