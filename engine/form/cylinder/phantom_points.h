// Points that were not measured: scanners and programs write one place, mostly 0 0 0, for each ray without an echo.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"

namespace lathelier::form {

/// The points that count, by their indices; empty when all of them do. Left out are places that ten points or more
/// share exactly where other places are held by few, and three points or more at the exact origin where all others
/// differ. One note phantomPoints for each such place. The same for any order of the points.
std::vector<std::size_t> withoutPhantoms(std::span<const Eigen::Vector3d> points_mm, Notes& notes,
                                         const Progress& progress = {});

}  // namespace lathelier::form
