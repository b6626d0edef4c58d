// Straightness of points in space, as of the axis of a stack of sections: least-squares and minimum-zone lines.
// Source: ISO 12780-1.
#pragma once

#include <Eigen/Core>
#include <span>

#include "engine/core/error.h"

namespace lathelier::form {

/// Straightness of points in space: the axis of a stack of sections.
struct StraightnessResult {
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();    ///< of the least-squares line: the points' mean
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< toward + on its dominant coordinate
    double axis_straightness_um = 0;  ///< diameter of the smallest cylinder about the points along the least-squares
                                      ///< line: 2 × MCC radius of the residuals
    double STRt_LSLI_um = 0;          ///< 2 × largest distance from the least-squares line
    double STRt_MZLI_um = 0;          ///< diameter of the smallest cylinder about the points, of any direction
};

/// Errors: tooFewPoints (fewer than 2), pointsDegenerate (all in one place).
StraightnessResult straightness(std::span<const Eigen::Vector3d> points_mm);

}  // namespace lathelier::form
