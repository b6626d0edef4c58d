// Checks of the points before an alignment.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

/// Errors, with `role` ("reference", "copy"): tooFewPoints (fewer than `least`), coordinateTooLarge (beyond 10 km or
/// not finite), pointsDegenerate (all in one place, on a line or in a plane).
void checkPoints(const std::vector<Eigen::Vector3d>& points, const char* role, const Progress& progress = {},
                 std::size_t least = 50);

}  // namespace lathelier::registration
