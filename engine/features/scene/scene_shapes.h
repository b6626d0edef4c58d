// Planes and groups of a cloud, by PCL: the largest plane by random samples (Fischler & Bolles 1981, RANSAC; the seed
// is fixed), groups by Euclidean distance.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace lathelier::features {

/// A plane n·p = d.
struct ScenePlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit vector
    double distance_mm = 0;                             ///< d
    std::vector<std::uint32_t> inliers;                 ///< indices of the points within the tolerance

    double height_mm(const Eigen::Vector3d& point) const { return normal.dot(point) - distance_mm; }
};

/// The plane that most points lie within `tolerance_mm` of; none: fewer than 3 points, or all on a line.
std::optional<ScenePlane> largestPlane(const std::vector<Eigen::Vector3d>& points, double tolerance_mm);

/// Points whose chains of neighbours are no further apart than `gap_mm`: indices, the largest group first, those with
/// fewer than `least` points left out.
std::vector<std::vector<std::uint32_t>> groupsOf(const std::vector<Eigen::Vector3d>& points, double gap_mm,
                                                 std::size_t least);

}  // namespace lathelier::features
