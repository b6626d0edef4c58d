// How far the flat facets of a mesh lie off the round surface that they stand for.
#pragma once

#include <Eigen/Geometry>

#include "engine/core/progress.h"
#include "engine/core/scan.h"

namespace lathelier::registration {

/// Of a body of revolution: what the chords of nine tenths of its side facets (those that face the axis or away from
/// it) stay below. 0 without such facets. Throws Cancelled.
double facetSagitta_mm(const Scan& mesh, const Eigen::Isometry3d& axis_T_mesh, const Progress& progress = {});

/// The same of all but a thousandth of them.
double largestSagitta_mm(const Scan& mesh, const Eigen::Isometry3d& axis_T_mesh, const Progress& progress = {});

}  // namespace lathelier::registration
