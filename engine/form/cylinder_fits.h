// Least-squares and minimum-zone cylinders.
// Source: ISO 12180-1; Forbes, "Least-squares best-fit geometric elements", NPL report DITC 140/89.
#pragma once

#include <vector>

#include "engine/form/cylinder_points.h"

namespace lathelier::form {

struct LeastSquaresCylinder {
    AxisParameters axis = AxisParameters::Zero();
    double radius = 0;
    double rms = 0;
    bool converged = false;
};

/// Where to look for a cylinder: coordinates near its axis, and the cylinder in them.
struct CylinderGuess {
    Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
    double scale_mm = 1;  ///< about the larger of radius and half length
    LeastSquaresCylinder cylinder;
};

/// The least-squares cylinder of some of the points, from many directions: near enough for any pose, long or short.
/// Errors: tooFewPoints, pointsDegenerate, notConverged, coordinateTooLarge.
CylinderGuess guessCylinder(std::span<const Eigen::Vector3d> points_mm, const Progress& progress);

/// Geometric least squares by damped Gauss-Newton from an axis near z.
LeastSquaresCylinder leastSquaresCylinder(const CylinderPoints& points, const LeastSquaresCylinder& start,
                                          const Progress& progress);

struct MinimumZoneCylinder {
    AxisParameters axis = AxisParameters::Zero();
    double inner = 0, outer = 0;
    std::vector<std::size_t> contacts;
};

/// The narrowest zone between coaxial cylinders near `start`: the best local optimum from several starts.
MinimumZoneCylinder minimumZoneCylinder(const CylinderPoints& points, const AxisParameters& start,
                                        const Progress& progress);

}  // namespace lathelier::form
