#include "engine/features/outline/edge_loss.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {
namespace {

/// The wall on one side of a shoulder.
struct WallBesideEdge {
    const Run* run = nullptr;
    double edge_mm = 0;
    double side = 1;                   ///< +1: the wall lies behind the edge
    std::vector<double> distances_mm;  ///< of its points from the edge
};

std::vector<WallBesideEdge> wallsBesideShoulders(const Model& model)
{
    std::vector<WallBesideEdge> walls;
    for (std::size_t r = 0; r + 1 < model.runs.size(); ++r) {
        const Run &a = model.runs[r], &b = model.runs[r + 1];
        const bool is_rough = a.elements.back().rough || b.elements.front().rough;
        const bool is_high =
            std::abs(startRadius_mm(b) - endRadius_mm(a)) > planeLimits.least_shoulder_sigmas * model.sigma_mm;
        if (a.right != b.left || is_rough || !is_high) continue;
        walls.push_back({&a, a.nodes_mm.back(), -1, {}});
        walls.push_back({&b, b.nodes_mm.front(), 1, {}});
    }
    return walls;
}

}  // namespace

double lossAtEdges_mm(const MeridianCloud& cloud, const Model& model)
{
    std::vector<WallBesideEdge> walls = wallsBesideShoulders(model);
    const double near = edgeLossLimits.wall_sigmas * model.sigma_mm;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        for (WallBesideEdge& wall : walls) {
            const double distance = (z - wall.edge_mm) * wall.side;
            const bool on_run = z > wall.run->nodes_mm.front() && z < wall.run->nodes_mm.back();
            if (distance < 0 || distance > edgeLossLimits.reach_mm || !on_run) continue;
            if (std::abs(r - radiusAt_mm(*wall.run, z)) < near) wall.distances_mm.push_back(distance);
        }
    }
    std::vector<double> losses;
    for (WallBesideEdge& wall : walls) {
        std::vector<double>& distances = wall.distances_mm;
        if (distances.size() < edgeLossLimits.least_points) continue;
        constexpr std::size_t last = edgeLossLimits.last_points;
        std::nth_element(distances.begin(), distances.begin() + (last - 1), distances.end());
        // Points that lie evenly come as near as this by chance.
        const double even = edgeLossLimits.reach_mm * static_cast<double>(last) / static_cast<double>(distances.size());
        losses.push_back(std::max(0.0, distances[last - 1] - even));
    }
    return losses.empty() ? edgeLossLimits.assumed_mm : upperMedianInPlace(losses);
}

}  // namespace lathelier::features
