#include "widgets/scene/scene_pick.h"

#include <limits>
#include <mutex>

#include "engine/core/parallel.h"

namespace lathelier::scene {

std::optional<ScenePick> nearestVisible(const std::vector<Eigen::Vector3d>& points_mm,
                                        const Eigen::Isometry3d& scene_T_points, const SceneCamera& camera,
                                        const std::optional<SceneSection>& section, const Eigen::Vector2d& pointer,
                                        double radius_px, int height_px)
{
    std::mutex mutex;
    std::vector<ScenePick> near;
    parallelFor(points_mm.size(), 65536, {}, [&](std::size_t begin, std::size_t end) {
        std::vector<ScenePick> found;
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3d scene = scene_T_points * points_mm[i];
            const auto place = camera.project(scene);
            if (!place) continue;
            Eigen::Vector2d away = (*place - pointer) * (height_px / 2.0);
            away.x() *= camera.aspect;
            if (away.squaredNorm() > radius_px * radius_px) continue;
            if (section && section->normal.dot(scene) < section->offset_mm) continue;
            found.push_back({i, -(camera.view_T_scene * scene).z(), away.norm()});
        }
        const std::lock_guard lock(mutex);
        near.insert(near.end(), found.begin(), found.end());
    });
    if (near.empty()) return std::nullopt;
    double front = std::numeric_limits<double>::infinity();
    for (const ScenePick& pick : near) front = std::min(front, pick.depth_mm);
    // Points within two radii behind the frontmost one belong to the same, possibly inclined, surface.
    const double perPixel = 2 * camera.half_height_mm * (camera.parallel ? 1 : front / camera.distance_mm) / height_px;
    const double layer = front + 2 * radius_px * perPixel;
    std::optional<ScenePick> best;
    for (const ScenePick& pick : near) {
        if (pick.depth_mm > layer) continue;
        if (!best || pick.away_px < best->away_px || (pick.away_px == best->away_px && pick.index < best->index))
            best = pick;
    }
    return best;
}

std::optional<SceneHit> firstHit(const Scan& mesh, const Eigen::Isometry3d& scene_T_mesh, const SceneCamera& camera,
                                 const std::optional<SceneSection>& section, const Eigen::Vector2d& pointer)
{
    // In view coordinates; `depth` of a hit is its distance in front of the eye.
    const Eigen::Isometry3d view_T_mesh = camera.view_T_scene * scene_T_mesh;
    const Eigen::Vector3d across(pointer.x() * camera.half_height_mm * camera.aspect,
                                 pointer.y() * camera.half_height_mm, 0);
    const Eigen::Vector3d start = camera.parallel ? across : Eigen::Vector3d::Zero();
    const Eigen::Vector3d way = camera.parallel
                                    ? Eigen::Vector3d(0, 0, -1)
                                    : Eigen::Vector3d(across / camera.distance_mm - Eigen::Vector3d::UnitZ());

    std::mutex mutex;
    std::optional<SceneHit> best;
    std::size_t bestTriangle = 0;
    parallelFor(mesh.triangles.size(), 16384, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& corners = mesh.triangles[i];
            const Eigen::Vector3d a = view_T_mesh * mesh.points_mm[corners[0]];
            const Eigen::Vector3d ab = view_T_mesh * mesh.points_mm[corners[1]] - a;
            const Eigen::Vector3d ac = view_T_mesh * mesh.points_mm[corners[2]] - a;
            const Eigen::Vector3d normal = way.cross(ac);
            const double volume = ab.dot(normal);
            if (volume == 0) continue;
            const Eigen::Vector3d from = start - a;
            const double u = from.dot(normal) / volume;
            const Eigen::Vector3d other = from.cross(ab);
            const double v = way.dot(other) / volume;
            const double depth = ac.dot(other) / volume;
            if (!(u >= 0 && v >= 0 && u + v <= 1 && depth > 0)) continue;
            const Eigen::Vector3d scene = camera.view_T_scene.inverse() * (start + depth * way);
            if (section && section->normal.dot(scene) < section->offset_mm) continue;
            const std::lock_guard lock(mutex);
            if (best && (depth > best->depth_mm || (depth == best->depth_mm && i > bestTriangle))) continue;
            best = SceneHit{{corners, Eigen::Vector3d(1 - u - v, u, v)}, depth};
            bestTriangle = i;
        }
    });
    return best;
}

}  // namespace lathelier::scene
