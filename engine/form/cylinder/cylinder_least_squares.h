// Least-squares cylinder from points in any pose. Source: ISO 12180-1; Forbes, "Least-squares best-fit geometric
// elements", NPL report DITC 140/89.
#pragma once

#include <span>

#include "engine/form/cylinder/cylinder_points.h"

namespace lathelier::form {

struct LeastSquaresCylinder {
    AxisParameters axis = AxisParameters::Zero();  ///< in the coordinates of CylinderPoints
    double radius = 0;                             ///< in the unit of CylinderPoints
    double rms = 0;                                ///< root mean square of distance - radius, in that unit
    bool converged = false;                        ///< false: no minimum found, or the points are nearly planar
};

/// Start value for a cylinder fit: a frame near its axis, and the cylinder in that frame.
struct CylinderGuess {
    Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();     ///< of the points: origin of the coordinates
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit vector near the axis: z of the coordinates
    double scale_mm = 1;                                   ///< about the larger of radius and half length
    LeastSquaresCylinder cylinder;                         ///< in the frame (mean_mm, direction, scale_mm)
};

/// The least-squares cylinder of some of the points, started from many directions: a start value for any pose and any
/// length. Errors: tooFewPoints, pointsDegenerate, notConverged, coordinateTooLarge.
CylinderGuess guessCylinder(std::span<const Eigen::Vector3d> points_mm, const Progress& progress);

/// Geometric least squares by damped Gauss-Newton from an axis near z.
LeastSquaresCylinder leastSquaresCylinder(const CylinderPoints& points, const LeastSquaresCylinder& start,
                                          const Progress& progress);

}  // namespace lathelier::form
