// The cross product in the plane.
#pragma once

#include <Eigen/Core>

namespace lathelier::form {

/// Positive where `b` lies anticlockwise of `a`.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace lathelier::form
