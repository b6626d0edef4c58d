// What is seen inside the rim of a hole across the axis: its floor, or the bottom of a dent.
#pragma once

#include <optional>

#include "engine/features/walls/walls.h"

namespace lathelier::features {

/// A rim about the axis of the part.
struct WallRim {
    double z_mm = 0, angle_rad = 0, radius_mm = 0;  ///< of the rim
    double wall_mm = 0;                             ///< radius of the wall there
};

struct HoleFloor {
    bool is_dent = false;            ///< its bottom rises to the rim: no wall stands below the rim
    std::optional<double> depth_mm;  ///< from the crown of the wall to the floor at the full diameter, where it is seen
};

/// `limit_mm`: points deeper below the wall are none of it.
HoleFloor floorOf(const MeridianCloud& cloud, const WallRim& rim, double limit_mm);

}  // namespace lathelier::features
