#include "engine/features/scene/loose_clusters.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/features/scene/point_cubes.h"
#include "engine/features/scene/surroundings_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int fitRounds = 6;
constexpr double fitSigmas = 3;  // points further from the middle do not take part in the fit
constexpr int fitRings = 2;      // cubes beside those of a cluster in which its other points are sought

/// Mean and covariance of points.
struct Spread {
    double count = 0;
    Vector3d sum = Vector3d::Zero();
    Matrix3d squares = Matrix3d::Zero();

    void add(const Vector3d& point)
    {
        count += 1;
        sum += point;
        squares += point * point.transpose();
    }
    Vector3d middle() const { return sum / count; }
    Matrix3d covariance() const { return squares / count - middle() * middle().transpose(); }
};

/// Standard deviations along the principal axes, ascending.
Vector3d deviations(const Matrix3d& covariance)
{
    Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
    solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
}

/// Do the points in the cube fill space? A corner of two sheets has 0.10 of the edge for its smallest deviation.
bool isFilled(const std::vector<Vector3d>& points, const PointCubes& cubes, std::size_t cube, double edge_mm,
              double sigma_mm)
{
    if (cubes.count(cube) < sceneLimits.least_in_cube) return false;
    Spread spread;
    const Vector3d origin = points[*cubes.begin(cube)];
    for (const std::uint32_t* i = cubes.begin(cube); i != cubes.end(cube); ++i) spread.add(points[*i] - origin);
    return deviations(spread.covariance())[0] >
           std::max(sceneLimits.cloud_sigmas * sigma_mm, sceneLimits.filled_deviation * edge_mm);
}

/// A normal distribution fitted to the points in the cubes; none where they are no cluster.
std::optional<LooseCluster> clusterIn(const std::vector<Vector3d>& points, const PointCubes& cubes,
                                      const std::vector<char>& filled, const std::vector<std::size_t>& group,
                                      double sigma_mm)
{
    const Vector3d origin = points[*cubes.begin(group.front())];
    Spread spread;
    for (const std::size_t cube : group)
        for (const std::uint32_t* i = cubes.begin(cube); i != cubes.end(cube); ++i) spread.add(points[*i] - origin);
    if (spread.count < static_cast<double>(sceneLimits.least_in_cluster)) return std::nullopt;
    const std::vector<std::size_t> near = cubes.around(group, fitRings);
    LooseCluster cluster;
    double core = 0, inside = 0, in_filled = 0, judged = 0;
    for (int round = 0; round < fitRounds; ++round) {
        const Matrix3d covariance = spread.covariance() + 1e-12 * Matrix3d::Identity();
        cluster.middle_mm = origin + spread.middle();
        cluster.inverse = covariance.inverse();
        cluster.reach_mm = sceneLimits.cluster_reach_sigmas * deviations(covariance)[2];
        spread = {};
        core = inside = in_filled = judged = 0;
        for (const std::size_t cube : near)
            for (const std::uint32_t* i = cubes.begin(cube); i != cubes.end(cube); ++i) {
                if (!cluster.contains(points[*i], fitSigmas)) continue;
                spread.add(points[*i] - origin);
                inside += 1;
                core += cluster.contains(points[*i], 1) ? 1 : 0;
                if (cubes.count(cube) < sceneLimits.least_in_cube) continue;
                judged += 1;
                in_filled += filled[cube] ? 1 : 0;
            }
        if (inside < static_cast<double>(sceneLimits.least_in_cluster)) return std::nullopt;
    }
    cluster.points = inside;
    const Vector3d sizes = deviations(spread.covariance());
    const bool is_cloud = sizes[0] > sceneLimits.cluster_ratio * sizes[2] &&
                          sizes[0] > sceneLimits.cloud_sigmas * sigma_mm && core > sceneLimits.core_share * inside &&
                          in_filled > sceneLimits.filled_share * judged;
#ifdef WSDBG
    std::fprintf(stderr, "cluster n %g mid %.1f %.1f %.1f sizes %.2f %.2f %.2f core %.2f filled %.2f group %zu %s\n",
                 inside, cluster.middle_mm.x(), cluster.middle_mm.y(), cluster.middle_mm.z(), sizes[0], sizes[1],
                 sizes[2], core / inside, in_filled / std::max(1.0, judged), group.size(), is_cloud ? "YES" : "no");
#endif
    return is_cloud ? std::optional(cluster) : std::nullopt;
}

}  // namespace

std::vector<LooseCluster> findClusters(const std::vector<Vector3d>& points, double sigma_mm, const Progress& progress)
{
    std::vector<LooseCluster> clusters;
    for (const bool thin : {false, true}) {
        const double edge_mm = thin ? sceneLimits.coarse_cube_mm : sceneLimits.fine_cube_mm;
        const PointCubes cubes(points, edge_mm);
        std::vector<char> filled(cubes.size(), 0);
        for (std::size_t cube = 0; cube < cubes.size(); ++cube)
            filled[cube] = isFilled(points, cubes, cube, edge_mm, sigma_mm) ? 1 : 0;
        for (const auto& group : cubes.groups([&](std::size_t cube) { return filled[cube] != 0; })) {
            progress.check();
            auto cluster = clusterIn(points, cubes, filled, group, sigma_mm);
            if (!cluster) continue;
            cluster->thin = thin;
            const auto known = std::find_if(clusters.begin(), clusters.end(), [&](const LooseCluster& one) {
                return one.contains(cluster->middle_mm, sceneLimits.cluster_reach_sigmas);
            });
            // In coarse cubes more of a cluster is found that a surface divides.
            if (known == clusters.end())
                clusters.push_back(*cluster);
            else if (cluster->points > known->points)
                *known = *cluster;
        }
    }
    return clusters;
}

}  // namespace lathelier::features
