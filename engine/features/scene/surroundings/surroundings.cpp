#include "engine/features/scene/surroundings/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/core/units.h"
#include "engine/features/scene/scene_groups.h"
#include "engine/features/scene/surroundings/holders.h"
#include "engine/features/scene/surroundings/loose_clusters.h"
#include "engine/features/scene/surroundings/seen_surface.h"
#include "engine/features/scene/surroundings/surroundings_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;

/// Points on no wall: on a face, or nowhere.
struct Strays {
    std::vector<std::uint32_t> face, off;
};

Strays straysOf(const MeridianCloud& cloud, const SeenSurface& surface, const Progress& progress)
{
    Strays strays;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        if (i % 65536 == 0) progress.check();
        const auto place = surface.placeOf(static_cast<double>(cloud.z_mm[i]), static_cast<double>(cloud.r_mm[i]));
        if (place == SeenSurface::Place::Face) strays.face.push_back(static_cast<std::uint32_t>(i));
        if (place == SeenSurface::Place::Off) strays.off.push_back(static_cast<std::uint32_t>(i));
    }
    return strays;
}

std::vector<Vector3d> pointsOnAxis(const MeridianCloud& cloud, const std::vector<std::uint32_t>& indices)
{
    std::vector<Vector3d> points;
    points.reserve(indices.size());
    for (const std::uint32_t i : indices) {
        const double angle = turn_rad * static_cast<double>(cloud.turn[i]);
        const auto r = static_cast<double>(cloud.r_mm[i]);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), static_cast<double>(cloud.z_mm[i]));
    }
    return points;
}

/// Is the wall of the part seen in most of the directions in which the cluster's points lie? A hole or a keyway, whose
/// points fill space too, interrupts the wall.
bool isWallBehind(const MeridianCloud& cloud, const SeenSurface& surface, const std::vector<Vector3d>& off,
                  const LooseCluster& cluster)
{
    using Cell = std::pair<long, long>;
    const auto cellOf = [](double z, double turn) {
        return Cell(std::lround(z), static_cast<long>(turn * surroundingsLimits.cell_turns));
    };
    std::map<Cell, bool> cells;
    for (const Vector3d& p : off) {
        if (!cluster.contains(p, 2) || !surface.isSeen(p.z())) continue;
        const double turn = std::atan2(p.y(), p.x()) / turn_rad;
        cells[cellOf(p.z(), turn < 0 ? turn + 1 : turn)] = false;
    }
    if (cells.empty()) return true;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const auto z = static_cast<double>(cloud.z_mm[i]);
        if (std::abs(z - cluster.middle_mm.z()) > cluster.reach_mm) continue;
        if (surface.placeOf(z, static_cast<double>(cloud.r_mm[i])) != SeenSurface::Place::Wall) continue;
        const auto cell = cells.find(cellOf(z, static_cast<double>(cloud.turn[i])));
        if (cell != cells.end()) cell->second = true;
    }
    const auto seen = std::count_if(cells.begin(), cells.end(), [](const auto& cell) { return cell.second; });
    return static_cast<double>(seen) >= surroundingsLimits.wall_behind_share * static_cast<double>(cells.size());
}

/// Labels of all points and what they mean.
class PointLabels {
public:
    explicit PointLabels(std::size_t count) : labels_(count, 0) {}

    template <class Indices>
    void add(const char* kind, const Indices& points)
    {
        kinds_.emplace_back(kind);
        for (const std::uint32_t i : points)
            if (labels_[i] == 0) labels_[i] = static_cast<std::uint16_t>(kinds_.size() - 1);
    }

    bool isPart(std::uint32_t point) const { return labels_[point] == 0; }
    bool empty() const { return kinds_.size() == 1; }
    Scene scene(const std::vector<Vector3d>& points) const
    {
        return sceneOf(points, labels_, kinds_, "body_of_revolution");
    }

private:
    std::vector<std::uint16_t> labels_;
    std::vector<std::string> kinds_{"part"};
};

/// Points of a wall within a cluster when these are clearly more than a quarter, a half and three quarters of a turn
/// further: then most of them are the cluster's.
std::vector<std::uint32_t> crowdOnWall(const MeridianCloud& cloud, const SeenSurface& surface,
                                       const LooseCluster& cluster)
{
    std::array<std::vector<std::uint32_t>, 4> found;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const auto z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        if (std::abs(z - cluster.middle_mm.z()) > cluster.reach_mm) continue;
        if (surface.placeOf(z, r) != SeenSurface::Place::Wall) continue;
        const double angle = turn_rad * static_cast<double>(cloud.turn[i]), c = std::cos(angle), s = std::sin(angle);
        const std::array<Vector3d, 4> turned{
            {{r * c, r * s, z}, {-r * s, r * c, z}, {-r * c, -r * s, z}, {r * s, -r * c, z}}};
        for (std::size_t quarter = 0; quarter < turned.size(); ++quarter)
            if (cluster.contains(turned[quarter], surroundingsLimits.crowd_sigmas))
                found[quarter].push_back(static_cast<std::uint32_t>(i));
    }
    const std::size_t usual = std::max({found[1].size(), found[2].size(), found[3].size()});
    const bool is_crowded =
        static_cast<double>(found[0].size()) >
        surroundingsLimits.crowd_ratio * static_cast<double>(usual + surroundingsLimits.least_in_cluster);
    return is_crowded ? found[0] : std::vector<std::uint32_t>{};
}

void labelClusters(const MeridianCloud& cloud, const SeenSurface& surface, const Strays& strays, double sigma_mm,
                   PointLabels& labels, const Progress& progress)
{
    // Rays across the axis see no faces: points there are stray ones.
    const bool has_faces = static_cast<double>(strays.face.size()) >
                           surroundingsLimits.faces_share * static_cast<double>(cloud.z_mm.size());
    std::vector<std::uint32_t> stray = strays.off;
    if (!has_faces) stray.insert(stray.end(), strays.face.begin(), strays.face.end());
    const std::vector<Vector3d> points = pointsOnAxis(cloud, stray);
    const std::vector<Vector3d> faces = pointsOnAxis(cloud, has_faces ? strays.face : std::vector<std::uint32_t>{});
    for (const LooseCluster& cluster : findClusters(points, sigma_mm, progress)) {
        if (cluster.thin && !isWallBehind(cloud, surface, points, cluster)) continue;
        std::vector<std::uint32_t> own;
        for (std::size_t k = 0; k < points.size(); ++k)
            if (cluster.contains(points[k], surroundingsLimits.cluster_reach_sigmas)) own.push_back(stray[k]);
        for (std::size_t k = 0; k < faces.size(); ++k)
            if (cluster.contains(faces[k], surroundingsLimits.cluster_reach_sigmas)) own.push_back(strays.face[k]);
        const std::vector<std::uint32_t> crowd = crowdOnWall(cloud, surface, cluster);
        own.insert(own.end(), crowd.begin(), crowd.end());
        labels.add("clutter", own);
    }
}

}  // namespace

Scene findSurroundings(const std::vector<Vector3d>& points, const registration::RevolutionFit& fit,
                       const MeridianCloud& cloud, const Walls& walls, const Progress& progress)
{
    const SeenSurface surface(cloud, walls);
    const Strays strays = straysOf(cloud, surface, progress);
    PointLabels labels(points.size());
    if (strays.off.size() >= surroundingsLimits.least_in_cluster)
        labelClusters(cloud, surface, strays, walls.sigma_mm, labels, progress);
    std::vector<std::uint32_t> off;
    for (const std::uint32_t i : strays.off)
        if (labels.isPart(i)) off.push_back(i);
    const std::vector<Vector3d> off_on_axis = pointsOnAxis(cloud, off);
    const std::vector<Holder> holders = findHolders({cloud, surface, off, off_on_axis}, progress);
    for (const Holder& holder : holders)
        for (const std::vector<std::uint32_t>& part : holder.parts) labels.add("clamp", part);
    if (labels.empty()) return {};
    Scene scene = labels.scene(points);
    const Eigen::Isometry3d scan_T_axis = fit.axis_T_scan.inverse();
    for (const Holder& holder : holders)
        if (holder.hides_end)
            scene.hidden.push_back({scan_T_axis * Vector3d(0, 0, holder.from_mm),
                                    scan_T_axis * Vector3d(0, 0, holder.to_mm), surroundingsLimits.hidden_end_mm});
    return scene;
}

}  // namespace lathelier::features
