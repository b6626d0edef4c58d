// The points of a scan about the part's axis.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::features {

/// The points in the part's frame, sorted into bins along z. Index i is that of the scan's point.
struct MeridianCloud {
    std::vector<float> z_mm, r_mm;         ///< along the axis, distance from it
    std::vector<float> turn;               ///< direction about the axis as a share of a turn, 0…1
    double z_first_mm = 0, z_last_mm = 0;  ///< of the data without sparse millimetres beyond the ends
    double points_per_mm = 0;              ///< median over the length
};

MeridianCloud meridianCloud(const std::vector<Eigen::Vector3d>& points_on_axis, const Progress& progress = {});

}  // namespace lathelier::features
