// Smallest enclosing circle. Source: Gärtner, "Fast and robust smallest enclosing balls", ESA 1999.
#pragma once

#include <span>
#include <vector>

#include "engine/form/circle/circle_points.h"

namespace lathelier::form {

struct EnclosingCircle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the units of the points
    double radius = 0;                                 ///< in the units of the points
    std::vector<std::size_t> contacts;                 ///< indices of the two or three points on the circle
};

/// Smallest circle around all points, for any number and any position (also all coincident): the farthest point is
/// added to the contacts until no point lies outside.
EnclosingCircle enclosingCircle(const CirclePoints& points);
EnclosingCircle enclosingCircle(std::span<const Eigen::Vector2d> points);

}  // namespace lathelier::form
