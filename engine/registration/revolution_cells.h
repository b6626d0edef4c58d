// The surface of a body of revolution in cells of z and angle that end at its shoulders and kinks.
#pragma once

#include "engine/registration/compare.h"
#include "engine/registration/meridian_line.h"
#include "engine/registration/surface_windows.h"

namespace lathelier::registration {

/// A run of the profile's bins without shoulder, kink or gap: from `first` to `last` - 1. Its limits are where the
/// edges are, as far as that is known; the profile's z.
struct SmoothRun {
    std::size_t first = 0;  ///< bin
    std::size_t last = 0;   ///< bin behind it
    double start_mm = 0;    ///< of the profile
    double end_mm = 0;      ///< of the profile
};

/// The outside's runs in order of z; runs of less than 3 bins are left out.
std::vector<SmoothRun> smoothRuns(const TurnedPart& part);

/// Zones where none are given, along the axis from the line's first point: between shoulders and kinks, a little away
/// from them, and no longer than an eighth of the part.
std::vector<Interval> automaticZones(const TurnedPart& part, const MeridianLine& line);

/// The windows of a comparison with a body of revolution, from the deviations of the used points (in the reference's
/// frame). What lies within 0.5 mm of an edge, where the scanner's spot smears, and on faces across the axis belongs to
/// no window. `facets_mm`: sagitta of a coarse reference mesh. The same bits for any number of threads.
SurfaceWindows revolutionWindows(const TurnedPart& reference, const MeridianLine& line,
                                 const std::vector<Eigen::Vector3d>& points, const CompareResult& result,
                                 double facets_mm, const Progress& progress = {});

/// How large the smallest cells are to be for so many points on so much surface: half a dozen points each, and no
/// larger than the data ask for, but not more cells than are worth their time.
double cellSize_mm(double points, double area_mm2);

}  // namespace lathelier::registration
