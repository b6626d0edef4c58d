// The two reference circles without local optima: least squares and smallest enclosing.
// Source: Kåsa, IEEE Trans. Instrum. Meas. 25 (1976) 8-14 (start); Gärtner, ESA 1999 (smallest enclosing circle).
#pragma once

#include <span>
#include <vector>

#include "engine/form/circle/circle_points.h"

namespace lathelier::form {

struct LeastSquaresCircle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the units of CirclePoints
    double radius = 0;                                 ///< likewise
    double rms = 0;                                    ///< root mean square of distance - radius
};

/// Geometric least squares by Newton's method from the algebraic circle (Kåsa). Error pointsDegenerate when the
/// points are so straight that the circle runs away.
LeastSquaresCircle leastSquaresCircle(const CirclePoints& points);

struct EnclosingCircle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the units of the points
    double radius = 0;                                 ///< likewise
    std::vector<std::size_t> contacts;                 ///< two or three
};

/// Smallest circle around all points, however few and wherever they lie (even all in one place): the farthest point
/// joins the contacts until none is outside (Gärtner, "Fast and robust smallest enclosing balls", ESA 1999).
EnclosingCircle enclosingCircle(const CirclePoints& points);
EnclosingCircle enclosingCircle(std::span<const Eigen::Vector2d> points);

}  // namespace lathelier::form
