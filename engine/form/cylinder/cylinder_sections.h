// Detection of points measured in sections across the axis.
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

/// Finds planes of constant x, y or z, whichever is closest to the axis: every point must lie in one plane, each plane
/// must hold at least eight points.
SectionStack sectionsAlong(std::span<const Eigen::Vector3d> points_mm, const Eigen::Vector3d& axis_point_mm,
                           const Eigen::Vector3d& axis_direction, const Progress& progress);

}  // namespace lathelier::form
