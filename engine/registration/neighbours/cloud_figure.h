// The paper's figure for a copy: the root mean square distance from cloud to cloud, with its standard error and its
// value for identical parts. Source: Miądlicki et al., "Remanufacturing System with Chatter Suppression for CNC
// Turning", section 3.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::registration {

struct CloudFigure {
    double rmse_mm = std::numeric_limits<double>::quiet_NaN();            ///< NaN: no point is within reach
    double standard_error_mm = std::numeric_limits<double>::quiet_NaN();  ///< of rmse_mm; 0: every point was queried
    double sampling_floor_mm = std::numeric_limits<double>::quiet_NaN();  ///< rmse_mm of identical parts
};

/// Root mean square distance of the copy's used points to the nearest reference point, those further than
/// `max_distance_mm` left out. Of more than 100 000 used points 25 000 are drawn, stratified; the standard error is
/// that of the sample. Throws Cancelled.
CloudFigure compareClouds(const std::vector<Eigen::Vector3d>& reference_mm,
                          const std::vector<Eigen::Vector3d>& moved_copy_mm, const std::vector<std::uint8_t>& used,
                          double max_distance_mm, const Progress& progress = {});

}  // namespace lathelier::registration
