// Coarse poses of a copy on its reference without an initial pose: starts over all rotations, each improved by a few
// steps, the best ones by more. Source of the even rotations: M. Alexa, "Super-Fibonacci spirals: fast, low-discrepancy
// sampling of SO(3)", CVPR 2022.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

/// One point for each occupied cell of a grid whose cells are `cell_mm` wide: the point nearest to the cell's mean.
/// In Hilbert order.
std::vector<Eigen::Vector3d> thinOut(const std::vector<Eigen::Vector3d>& points_mm, double cell_mm,
                                     const Progress& progress = {});

/// Up to `count` distinct poses reference_T_copy, in order of increasing misfit.
/// Both clouds evenly thinned to a few thousand points, at least 3 each. The copy may lack up to about a third of the
/// reference or the other way round. Throws Cancelled.
std::vector<Eigen::Isometry3d> findCoarsePoses(const std::vector<Eigen::Vector3d>& reference_mm,
                                               const std::vector<Eigen::Vector3d>& copy_mm, std::size_t count,
                                               const Progress& progress = {});

}  // namespace lathelier::registration
