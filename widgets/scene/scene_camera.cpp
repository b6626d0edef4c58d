#include "widgets/scene/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace lathelier::scene {
namespace {

constexpr double halfViewAngle = 15 * M_PI / 180;
constexpr double margin = 1.06;

/// Direction from the part to the eye and up direction, in frame coordinates.
std::pair<Eigen::Vector3d, Eigen::Vector3d> directions(SceneViewpoint viewpoint)
{
    switch (viewpoint) {
        case SceneViewpoint::Side: return {{0, 0, 1}, {0, 1, 0}};
        case SceneViewpoint::Top: return {{0, 1, 0}, {0, 0, -1}};
        case SceneViewpoint::End: return {{1, 0, 0}, {0, 1, 0}};
        case SceneViewpoint::Oblique: break;
    }
    return {Eigen::Vector3d(0.62, 0.42, 0.66).normalized(), {0, 1, 0}};
}

}  // namespace

std::optional<Eigen::Vector2d> SceneCamera::project(const Eigen::Vector3d& scene) const
{
    const Eigen::Vector3d view = view_T_scene * scene;
    if (view.z() >= 0) return std::nullopt;
    const double half = parallel ? half_height_mm : half_height_mm * -view.z() / distance_mm;
    return Eigen::Vector2d(view.x() / (half * aspect), view.y() / half);
}

Eigen::Matrix3d levelFrame(const Eigen::Vector3d& along)
{
    const Eigen::Vector3d u = along.normalized();
    int across = 2;
    for (const int candidate : {1, 0})
        if (std::abs(u[candidate]) < std::abs(u[across]) - 0.1) across = candidate;
    Eigen::Vector3d up = Eigen::Vector3d::Unit(across);
    up = (up - up.dot(u) * u).normalized();
    Eigen::Matrix3d frame;
    frame << u, up, u.cross(up);
    return frame;
}

SceneCamera cameraFor(SceneViewpoint viewpoint, const Eigen::Matrix3d& frame, const Eigen::Vector3d& low,
                      const Eigen::Vector3d& high, double aspect, bool parallel)
{
    const auto [toEye, up] = directions(viewpoint);
    Eigen::Matrix3d view_T_frame;
    view_T_frame.row(0) = up.cross(toEye).normalized();
    view_T_frame.row(2) = toEye;
    view_T_frame.row(1) = toEye.cross(view_T_frame.row(0).transpose());
    const Eigen::Vector3d centre = (low + high) / 2;

    // Least distance at which all eight corners of the box are visible.
    const double slope = std::tan(halfViewAngle);
    double distance = 0, half = 0, front = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d point(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                                    corner & 4 ? high.z() : low.z());
        const Eigen::Vector3d v = view_T_frame * (point - centre);
        const double reach = std::max(std::abs(v.y()), std::abs(v.x()) / aspect);
        half = std::max(half, reach);
        front = std::max(front, v.z());
        distance = std::max(distance, v.z() + margin * reach / slope);
    }
    SceneCamera camera;
    camera.parallel = parallel;
    camera.aspect = aspect;
    camera.distance_mm = std::max(parallel ? 2 * front + half / slope : distance, 1e-3);
    camera.half_height_mm = std::max(parallel ? margin * half : camera.distance_mm * slope, 1e-6);
    const Eigen::Matrix3d viewTurn = view_T_frame * frame.transpose();
    camera.view_T_scene.linear() = viewTurn;
    camera.view_T_scene.translation() = -(viewTurn * (frame * centre)) - Eigen::Vector3d(0, 0, camera.distance_mm);
    return camera;
}

std::vector<std::uint32_t> thinnedOrder(std::size_t count, std::size_t most)
{
    // Prefix of a random permutation: uniform coverage without the aliasing of a regular step on a scan grid.
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::mt19937 random(1);
    const std::size_t size = std::min(count, most);
    for (std::size_t i = 0; i < size; ++i) std::swap(order[i], order[i + random() % (count - i)]);
    order.resize(size);
    return order;
}

}  // namespace lathelier::scene
