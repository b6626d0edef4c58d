// Picking: the nearest point of a cloud's front layer, or the place on a mesh. No VTK here.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/scan.h"
#include "widgets/scene/scene_camera.h"

namespace lathelier::scene {

struct ScenePick {
    std::size_t index = 0;  ///< of the point in its cloud
    double depth_mm = 0;    ///< from the eye
    double away_px = 0;     ///< from the pointer
};

/// The point nearest to the pointer among those of the front layer: all points within `radius_px` of it are projected
/// exactly, and those clearly behind the frontmost are excluded. `pointer` as given by SceneCamera::project.
std::optional<ScenePick> nearestVisible(const std::vector<Eigen::Vector3d>& points_mm,
                                        const Eigen::Isometry3d& scene_T_points, const SceneCamera& camera,
                                        const std::optional<SceneSection>& section, const Eigen::Vector2d& pointer,
                                        double radius_px, int height_px);

struct SceneHit {
    PickedPlace place;    ///< on the mesh
    double depth_mm = 0;  ///< from the eye
};

/// Where the ray through the pointer meets the mesh first, on the drawn side of the section. Ray and triangle after
/// T. Möller and B. Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
std::optional<SceneHit> firstHit(const Scan& mesh, const Eigen::Isometry3d& scene_T_mesh, const SceneCamera& camera,
                                 const std::optional<SceneSection>& section, const Eigen::Vector2d& pointer);

}  // namespace lathelier::scene
