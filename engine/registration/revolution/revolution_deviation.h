// Comparison with a body of revolution: deviation from its meridian, unrolled map, mean meridian.
#pragma once

#include "engine/registration/compare.h"
#include "engine/registration/revolution/meridian_line.h"

namespace lathelier::registration {

/// Distance of every point (in the reference's frame) from the reference's meridian; NaN where there is none.
std::vector<float> meridianDeviation(const TurnedPart& reference, const MeridianLine& line,
                                     const std::vector<Eigen::Vector3d>& points, double max_distance_mm,
                                     const Progress& progress = {});

/// Takes the points in the excluded zones of the parameters out of `deviation_mm` and `used`. Gives how many those
/// were.
std::int64_t excludeZones(const TurnedPart& reference, const MeridianLine& line,
                          const std::vector<Eigen::Vector3d>& points, CompareResult& result,
                          const Progress& progress = {});

/// Fills meridian and unrolled map from the deviations of the used points. z counts from the line's first point along
/// the reported axis.
void describeRevolution(const TurnedPart& reference, const MeridianLine& line,
                        const std::vector<Eigen::Vector3d>& points, CompareResult& result,
                        const Progress& progress = {});

}  // namespace lathelier::registration
