#include "engine/features/scene/surroundings/loose_clusters.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/features/scene/surroundings/point_cubes.h"
#include "engine/features/scene/surroundings/surroundings_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

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

/// Clusters among points in cubes of one size.
class ClusterSearch {
public:
    ClusterSearch(const std::vector<Vector3d>& points, double edge_mm, double sigma_mm)
        : points_(points), cubes_(points, edge_mm), sigma_mm_(sigma_mm), filled_(cubes_.size(), 0)
    {
        for (std::size_t cube = 0; cube < cubes_.size(); ++cube) filled_[cube] = isFilled(cube, edge_mm) ? 1 : 0;
    }

    std::vector<LooseCluster> find(const Progress& progress) const
    {
        std::vector<LooseCluster> found;
        for (const auto& group : cubes_.groups([&](std::size_t cube) { return filled_[cube] != 0; })) {
            progress.check();
            if (const auto whole = clusterAt(group))
                found.push_back(*whole);
            else
                addOverlapping(group, found);
        }
        return found;
    }

private:
    Spread spreadOf(const std::vector<std::size_t>& cubes, const Vector3d& origin) const
    {
        Spread spread;
        for (const std::size_t cube : cubes)
            for (const std::uint32_t* i = cubes_.begin(cube); i != cubes_.end(cube); ++i)
                spread.add(points_[*i] - origin);
        return spread;
    }

    /// Do the points in the cube fill space? A corner of two sheets has 0.10 of the edge for its smallest deviation.
    bool isFilled(std::size_t cube, double edge_mm) const
    {
        if (cubes_.count(cube) < surroundingsLimits.least_in_cube) return false;
        const Spread spread = spreadOf({cube}, points_[*cubes_.begin(cube)]);
        return deviations(spread.covariance())[0] >
               std::max(surroundingsLimits.cloud_sigmas * sigma_mm_, surroundingsLimits.filled_deviation * edge_mm);
    }

    /// Clusters that overlap: a fit that begins at each of the densest cubes.
    void addOverlapping(std::vector<std::size_t> group, std::vector<LooseCluster>& found) const
    {
        std::stable_sort(group.begin(), group.end(),
                         [&](std::size_t a, std::size_t b) { return cubes_.count(a) > cubes_.count(b); });
        int tried = 0;
        for (const std::size_t cube : group) {
            const Vector3d origin = points_[*cubes_.begin(cube)];
            const Vector3d middle = origin + spreadOf({cube}, origin).middle();
            const auto holds = [&](const LooseCluster& one) {
                return one.contains(middle, surroundingsLimits.fit_sigmas);
            };
            if (std::any_of(found.begin(), found.end(), holds)) continue;
            if (++tried > surroundingsLimits.most_seeds) return;
            if (const auto one = clusterAt({cube})) found.push_back(*one);
        }
    }

    /// A normal distribution fitted to the points in and about the cubes; none where they are no cluster.
    std::optional<LooseCluster> clusterAt(const std::vector<std::size_t>& group) const
    {
        const Vector3d origin = points_[*cubes_.begin(group.front())];
        const std::vector<std::size_t> near = cubes_.around(group, surroundingsLimits.fit_rings);
        Spread spread = spreadOf(group, origin);
        LooseCluster cluster;
        double core = 0, in_filled = 0, judged = 0;
        for (int round = 0; round < surroundingsLimits.fit_rounds; ++round) {
            const Matrix3d covariance = spread.covariance() + 1e-12 * Matrix3d::Identity();
            cluster.middle_mm = origin + spread.middle();
            cluster.inverse = covariance.inverse();
            cluster.reach_mm = surroundingsLimits.cluster_reach_sigmas * deviations(covariance)[2];
            spread = {};
            core = in_filled = judged = 0;
            for (const std::size_t cube : near)
                for (const std::uint32_t* i = cubes_.begin(cube); i != cubes_.end(cube); ++i) {
                    if (!cluster.contains(points_[*i], surroundingsLimits.fit_sigmas)) continue;
                    spread.add(points_[*i] - origin);
                    core += cluster.contains(points_[*i], 1) ? 1 : 0;
                    if (cubes_.count(cube) < surroundingsLimits.least_in_cube) continue;
                    judged += 1;
                    in_filled += filled_[cube] ? 1 : 0;
                }
            if (spread.count < static_cast<double>(surroundingsLimits.least_in_cube)) return std::nullopt;
        }
        cluster.points = spread.count;
        const Vector3d sizes = deviations(spread.covariance());
        const bool is_cloud = spread.count >= static_cast<double>(surroundingsLimits.least_in_cluster) &&
                              sizes[0] > surroundingsLimits.cluster_ratio * sizes[2] &&
                              sizes[0] > surroundingsLimits.cloud_sigmas * sigma_mm_ &&
                              core > surroundingsLimits.core_share * spread.count &&
                              in_filled > surroundingsLimits.filled_share * judged;
        return is_cloud ? std::optional(cluster) : std::nullopt;
    }

    const std::vector<Vector3d>& points_;
    PointCubes cubes_;
    double sigma_mm_;
    std::vector<char> filled_;
};

}  // namespace

std::vector<LooseCluster> findClusters(const std::vector<Vector3d>& points, double sigma_mm, const Progress& progress)
{
    std::vector<LooseCluster> clusters =
        ClusterSearch(points, surroundingsLimits.fine_cube_mm, sigma_mm).find(progress);
    for (LooseCluster& cluster : ClusterSearch(points, surroundingsLimits.coarse_cube_mm, sigma_mm).find(progress)) {
        cluster.thin = true;
        const auto known = std::find_if(clusters.begin(), clusters.end(), [&](const LooseCluster& one) {
            return one.contains(cluster.middle_mm, surroundingsLimits.cluster_reach_sigmas);
        });
        // In coarse cubes more is found of a cluster that a surface divides.
        if (known == clusters.end())
            clusters.push_back(cluster);
        else if (cluster.points > known->points)
            *known = cluster;
    }
    return clusters;
}

}  // namespace lathelier::features
