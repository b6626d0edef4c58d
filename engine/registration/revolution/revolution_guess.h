// Starting values for the axis of a body of revolution.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

/// Starts for the axis, best first, and how far neighbouring points scatter about a plane (noise, and some curvature).
struct AxisCandidates {
    std::vector<Eigen::Isometry3d> axis_T_scan;  ///< best first: the axis is z
    double noise_mm = 0;                         ///< scatter of neighbouring points about a plane
};

/// Starting directions and places of the axis. `points` are 1000 to 30 000 spread over the surface.
/// Normal lines of a surface of revolution meet its axis: the linear complex of Pottmann and Wallner,
/// "Computational Line Geometry", 2001, section 4.2, solved with robust weights; and the principal axes.
AxisCandidates findAxisCandidates(const std::vector<Eigen::Vector3d>& points, const Progress& progress);

}  // namespace lathelier::registration
