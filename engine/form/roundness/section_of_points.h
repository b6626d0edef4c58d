// One section from points of a body of revolution, as a roundness instrument would trace it.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "engine/core/profile.h"
#include "engine/core/progress.h"

namespace lathelier::form {

/// Where to cut.
struct SectionCut {
    double z_mm = 0;      ///< position of the section along the axis
    double width_mm = 1;  ///< of the slice about it whose points are used
};

/// The mean place of the points in each of equal angles about the axis, seen along it; angles without points are left
/// out. So many angles that about twenty points, which average the noise of a scan, fall into each (36 to 720), or one
/// for each point of a sparse section. `axis_T_points` transforms the points into a frame with the axis as z. Error
/// tooFewPoints (fewer than 12 in the slice). Throws Cancelled.
Profile sectionOfPoints(std::span<const Eigen::Vector3d> points_mm, const Eigen::Isometry3d& axis_T_points,
                        const SectionCut& cut, const Progress& progress = {});

}  // namespace lathelier::form
