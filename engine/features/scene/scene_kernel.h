// What the module lathelier-pcl does with PCL: planes and groups of a cloud.
#pragma once

#include "engine/features/scene/scene_shapes.h"

namespace lathelier::features {

struct SceneKernel {
    decltype(&largestPlane) largest_plane;
    decltype(&groupsOf) groups_of;
};

}  // namespace lathelier::features
