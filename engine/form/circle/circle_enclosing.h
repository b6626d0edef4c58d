// The smallest circle around points.
// Source: Gärtner, "Fast and robust smallest enclosing balls", ESA 1999.
#pragma once

#include <span>
#include <vector>

#include "engine/form/circle/circle_points.h"

namespace lathelier::form {

struct EnclosingCircle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the units of the points
    double radius = 0;                                 ///< likewise
    std::vector<std::size_t> contacts;                 ///< two or three
};

/// Smallest circle around all points, however few and wherever they lie (even all in one place): the farthest point
/// joins the contacts until none is outside.
EnclosingCircle enclosingCircle(const CirclePoints& points);
EnclosingCircle enclosingCircle(std::span<const Eigen::Vector2d> points);

}  // namespace lathelier::form
