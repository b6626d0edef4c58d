// The least-squares circle.
// Source: Kåsa, IEEE Trans. Instrum. Meas. 25 (1976) 8-14 (start).
#pragma once

#include "engine/form/circle/circle_points.h"

namespace lathelier::form {

struct LeastSquaresCircle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< in the units of CirclePoints
    double radius = 0;                                 ///< in the units of CirclePoints
    double rms = 0;                                    ///< root mean square of distance - radius
};

/// Geometric least squares by Newton's method from the algebraic circle (Kåsa). Error pointsDegenerate when the points
/// are so nearly collinear that the radius diverges.
LeastSquaresCircle leastSquaresCircle(const CirclePoints& points);

}  // namespace lathelier::form
