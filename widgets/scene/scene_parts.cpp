#include "widgets/scene/scene_parts.h"

#include <vtkCamera.h>

#include <cmath>
#include <limits>

#include "engine/core/parallel.h"

namespace lathelier::scene {

SceneBox extent(const std::vector<SceneObject>& objects, const Eigen::Matrix3d& frame)
{
    const Eigen::Vector3d beyond = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    const SceneBox nothing{beyond, -beyond};
    SceneBox box = nothing;
    for (const SceneObject& object : objects) {
        const auto& points = object.scan->points_mm;
        const Eigen::Isometry3d toFrame = Eigen::Isometry3d(frame.transpose()) * object.scene_T_scan;
        box = parallelReduce(
            points.size(), 65536, {}, box,
            [&](std::size_t begin, std::size_t end) {
                SceneBox part = nothing;
                for (std::size_t i = begin; i < end; ++i) {
                    const Eigen::Vector3d p = toFrame * points[i];
                    part.low = part.low.cwiseMin(p);
                    part.high = part.high.cwiseMax(p);
                }
                return part;
            },
            [](const SceneBox& a, const SceneBox& b) {
                return SceneBox{a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
            });
    }
    if (!(box.low.array() <= box.high.array()).all())
        return {Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1)};
    return box;
}

SceneCamera SceneView::Parts::camera() const
{
    vtkCamera* eye = canvas->renderer().GetActiveCamera();
    const Eigen::Vector3d place = Eigen::Vector3d(eye->GetPosition()) + origin;
    const Eigen::Vector3d target = Eigen::Vector3d(eye->GetFocalPoint()) + origin;
    SceneCamera camera;
    Eigen::Matrix3d rows;
    rows.row(2) = (place - target).normalized();
    rows.row(0) = Eigen::Vector3d(eye->GetViewUp()).cross(rows.row(2).transpose()).normalized();
    rows.row(1) = rows.row(2).cross(rows.row(0));
    camera.view_T_scene.linear() = rows;
    camera.view_T_scene.translation() = -(rows * place);
    camera.distance_mm = (place - target).norm();
    camera.parallel = eye->GetParallelProjection() != 0;
    camera.half_height_mm =
        camera.parallel ? eye->GetParallelScale() : camera.distance_mm * std::tan(eye->GetViewAngle() * M_PI / 360);
    camera.aspect = aspect();
    return camera;
}

void SceneView::Parts::aim(const SceneCamera& camera)
{
    vtkCamera* eye = canvas->renderer().GetActiveCamera();
    const Eigen::Isometry3d scene_T_view = camera.view_T_scene.inverse();
    const Eigen::Vector3d place = scene_T_view.translation() - origin;
    const Eigen::Vector3d target = scene_T_view * Eigen::Vector3d(0, 0, -camera.distance_mm) - origin;
    const Eigen::Vector3d up = scene_T_view.linear().col(1);
    eye->SetPosition(place.data());
    eye->SetFocalPoint(target.data());
    eye->SetViewUp(up.data());
    eye->SetParallelProjection(camera.parallel);
    eye->SetParallelScale(camera.half_height_mm);
    eye->SetViewAngle(2 * std::atan(camera.half_height_mm / camera.distance_mm) * 180 / M_PI);
}

}  // namespace lathelier::scene
