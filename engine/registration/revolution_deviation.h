// What a body of revolution adds to a comparison: deviation from its meridian, zones, unrolled map, mean meridian.
#pragma once

#include "engine/registration/compare.h"
#include "engine/registration/meridian_line.h"

namespace lathelier {

/// Fills `deviation_mm` and `used` of `result` (which holds the alignment and the parameters) with the distance of
/// every point of the copy from the reference's meridian. Gives the number of points left out for lying too far away
/// and for lying in excluded zones.
struct LeftOut {
    std::int64_t far = 0;
    std::int64_t zones = 0;
};
LeftOut measureRevolution(const TurnedPart& reference, const MeridianLine& line,
                          const std::vector<Eigen::Vector3d>& copy, double max_distance_mm, CompareResult& result,
                          const Progress& progress = {});

/// Fills meridian, zones and unrolled map from the deviations of the used points. z counts from the line's first point
/// along the reported axis. Zones lie between shoulders and kinks of the reference, a little away from them, and are no
/// longer than an eighth of the part.
void describeRevolution(const TurnedPart& reference, const MeridianLine& line, const std::vector<Eigen::Vector3d>& copy,
                        CompareResult& result, const Progress& progress = {});

}  // namespace lathelier
