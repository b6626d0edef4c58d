// One point for each cube of a grid that holds any.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::features {

struct Thinned {
    double edge_mm = 1;                   ///< of a cube
    std::vector<Eigen::Vector3d> points;  ///< the first point of each cube, in the order of their first points
    std::vector<std::uint32_t> of_point;  ///< which cube a point is in, as an index into `points`
};

Thinned thinned(const std::vector<Eigen::Vector3d>& points, double edge_mm, const Progress& progress = {});

/// At most `most` of the points, evenly from their order.
std::vector<Eigen::Vector3d> everyNth(const std::vector<Eigen::Vector3d>& points, std::size_t most);

/// Diagonal of the box that holds the middle 98 % of the points along each axis.
double usualExtent_mm(const std::vector<Eigen::Vector3d>& points);

}  // namespace lathelier::features
