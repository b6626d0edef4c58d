// A cloud of points that lies in sections across its axis.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::form {

struct SectionStack {
    double length_mm = 0;                     ///< of all points along the axis
    std::vector<Eigen::Vector3d> centres_mm;  ///< least-squares centre of each section along the axis; empty: none
};

/// Finds planes of constant x, y or z, whichever the axis follows most: every point has to lie in one, and each has to
/// hold eight points at least.
SectionStack sectionsAlong(std::span<const Eigen::Vector3d> points_mm, const Eigen::Vector3d& axis_point_mm,
                           const Eigen::Vector3d& axis_direction, const Progress& progress);

}  // namespace lathelier::form
