// The surface of a part of any shape in cells: cubes in space, split by where the surface faces.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/registration/compare.h"
#include "engine/registration/verdict/surface_windows.h"

namespace lathelier::registration {

/// The windows of a comparison with a part of any shape, from the deviations of the used points (in the reference's
/// frame) and the directions in which they are measured (surface_deviation.h). What lies near an edge of the part
/// belongs to no window: there the scanner's spot and the surface between the points cause systematic errors.
/// The same bits for any number of threads.
SurfaceWindows generalWindows(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3f>& normals,
                              const CompareResult& result, const Progress& progress = {});

}  // namespace lathelier::registration
