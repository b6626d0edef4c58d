// The surface of a body of revolution in cells of z and angle that end at its shoulders and kinks.
#pragma once

#include "engine/registration/compare.h"
#include "engine/registration/revolution/meridian_line.h"
#include "engine/registration/verdict/surface_windows.h"

namespace lathelier::registration {

/// The windows of a comparison with a body of revolution, from the deviations of the used points (in the reference's
/// frame). What lies within 0.5 mm of an edge, where the scanner's spot smears, belongs to no window, nor do faces
/// across the axis that the reference shows no points of. `facets_mm`: sagitta of a coarse reference mesh. The same
/// bits for any number of threads.
SurfaceWindows revolutionWindows(const TurnedPart& reference, const MeridianLine& line,
                                 const std::vector<Eigen::Vector3d>& points, const CompareResult& result,
                                 double facets_mm, const Progress& progress = {});

}  // namespace lathelier::registration
