// Groups of a scene from the label of each point, and two scenes one after the other.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/features/scene/scene.h"

namespace lathelier::features {

/// `labels`: one per point, index into `kinds`; 0 is the part. `reason`: SceneGroup::reason of the part. Empty when all
/// points are the part's. Beyond the twelve largest groups all are joined into one.
Scene sceneOf(const std::vector<Eigen::Vector3d>& points, const std::vector<std::uint16_t>& labels,
              const std::vector<std::string>& kinds, const std::string& reason);

/// A scene, and one of the points that it keeps: a scene of all points.
Scene joined(Scene scene, const Scene& of_kept);

}  // namespace lathelier::features
