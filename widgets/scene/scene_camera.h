// The camera as numbers: standard viewpoints, fitting a part. No VTK here. Picking: scene_pick.h.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "widgets/scene/scene_data.h"

namespace lathelier::scene {

/// Position of the eye and projection. View coordinates: x right, y up, z toward the eye, which is the origin.
struct SceneCamera {
    Eigen::Isometry3d view_T_scene = Eigen::Isometry3d::Identity();  ///< from the scene into view coordinates
    double distance_mm = 1;                                          ///< from the eye to what it looks at
    bool parallel = false;                                           ///< parallel projection; false: perspective
    double half_height_mm = 1;                                       ///< half of the visible height at that distance
    double aspect = 1;                                               ///< width / height of the picture

    /// Place in the picture: x from -1 (left) to 1, y from -1 (bottom) to 1; nothing behind the eye.
    std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& scene) const;
};

/// A right-handed frame: level along the part, up, toward the viewer of the side view. Up is the world axis most
/// across the part (z before y before x).
Eigen::Matrix3d levelFrame(const Eigen::Vector3d& along);

/// The camera of a standard viewpoint that just holds the box [low, high] given in `frame` coordinates.
SceneCamera cameraFor(SceneViewpoint viewpoint, const Eigen::Matrix3d& frame, const Eigen::Vector3d& low,
                      const Eigen::Vector3d& high, double aspect, bool parallel);

/// Drawn half space: normal · p >= offset, in scene coordinates.
struct SceneSection {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< unit vector toward the part that is drawn
    double offset_mm = 0;                               ///< of the plane from the scene's origin along the normal
};

/// Indices of which any prefix covers the whole evenly: at most `most`, deterministic.
std::vector<std::uint32_t> thinnedOrder(std::size_t count, std::size_t most);

}  // namespace lathelier::scene
