// Sagitta of the flat facets of a mesh under the round surface that they approximate.
#pragma once

#include <Eigen/Geometry>

#include "engine/core/progress.h"
#include "engine/core/scan.h"

namespace lathelier::registration {

/// Of a body of revolution: 90 % quantile of the sagitta over its side facets (normal toward or away from the axis). 0
/// without such facets. Throws Cancelled.
double facetSagitta_mm(const Scan& mesh, const Eigen::Isometry3d& axis_T_mesh, const Progress& progress = {});

/// The 99.9 % quantile.
double largestSagitta_mm(const Scan& mesh, const Eigen::Isometry3d& axis_T_mesh, const Progress& progress = {});

}  // namespace lathelier::registration
