// Default of max_distance_mm: the largest distance of a used point from the reference.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace lathelier::registration {

/// Twice the distance within which nine tenths of the points lie from the middle (the median of each coordinate):
/// spurious points hardly change it. At least one point, all finite.
double robustSize_mm(const std::vector<Eigen::Vector3d>& points_mm);

/// 0.6 % of the part's size (1 mm on a shaft of 183 mm), never less than 10 standard deviations of the noise. A noise
/// above 1 % of the size is ignored (the points lie on no surface). `scatter_mm`, the standard deviation of the
/// deviations found, may include a misfit: ten of it count up to 2 % of the size.
double defaultReach_mm(double size_mm, double noise_mm, double scatter_mm = 0);

}  // namespace lathelier::registration
