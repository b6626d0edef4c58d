#define PCL_NO_PRECOMPILE  // only templates are used: the shared libraries of instances are not loaded
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/impl/extract_clusters.hpp>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "engine/features/scene/scene_kernel.h"
#include "engine/features/scene/scene_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Single precision about the middle of the points.
Cloud::Ptr cloudOf(const std::vector<Vector3d>& points, const Vector3d& middle)
{
    Cloud::Ptr cloud(new Cloud);
    cloud->reserve(points.size());
    for (const Vector3d& point : points) {
        const Eigen::Vector3f p = (point - middle).cast<float>();
        cloud->emplace_back(p.x(), p.y(), p.z());
    }
    return cloud;
}

Vector3d middleOf(const std::vector<Vector3d>& points)
{
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& point : points) sum += point;
    return points.empty() ? sum : Vector3d(sum / static_cast<double>(points.size()));
}

void fitTo(const std::vector<Vector3d>& points, ScenePlane& plane)
{
    Vector3d middle = Vector3d::Zero();
    for (const std::uint32_t i : plane.inliers) middle += points[i];
    middle /= static_cast<double>(plane.inliers.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const std::uint32_t i : plane.inliers) spread += (points[i] - middle) * (points[i] - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    plane.normal = solver.eigenvectors().col(0);
    plane.distance_mm = plane.normal.dot(middle);
}

std::optional<ScenePlane> planeByConsensus(const std::vector<Vector3d>& points, double tolerance_mm)
{
    if (points.size() < 3) return std::nullopt;
    const Vector3d middle = middleOf(points);
    const pcl::SampleConsensusModelPlane<pcl::PointXYZ>::Ptr model(
        new pcl::SampleConsensusModelPlane<pcl::PointXYZ>(cloudOf(points, middle)));
    pcl::RandomSampleConsensus<pcl::PointXYZ> consensus(model, tolerance_mm);
    consensus.setMaxIterations(sceneLimits.plane_iterations);
    consensus.setProbability(sceneLimits.plane_confidence);
    if (!consensus.computeModel()) return std::nullopt;
    Eigen::VectorXf found;
    consensus.getModelCoefficients(found);
    ScenePlane plane;
    plane.normal = found.head<3>().cast<double>().normalized();
    plane.distance_mm = plane.normal.dot(middle) - static_cast<double>(found[3]);
    for (int round = 0; round < sceneLimits.plane_fit_rounds; ++round) {
        plane.inliers.clear();
        for (std::size_t i = 0; i < points.size(); ++i)
            if (std::abs(plane.height_mm(points[i])) <= tolerance_mm)
                plane.inliers.push_back(static_cast<std::uint32_t>(i));
        if (plane.inliers.size() < 3) return std::nullopt;
        fitTo(points, plane);
    }
    return plane;
}

std::vector<std::vector<std::uint32_t>> groupsByDistance(const std::vector<Vector3d>& points, double gap_mm,
                                                         std::size_t least)
{
    std::vector<std::vector<std::uint32_t>> groups;
    if (points.empty()) return groups;
    const Cloud::Ptr cloud = cloudOf(points, middleOf(points));
    const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>(false));
    tree->setInputCloud(cloud);
    std::vector<pcl::PointIndices> found;
    pcl::extractEuclideanClusters<pcl::PointXYZ>(*cloud, tree, static_cast<float>(gap_mm), found,
                                                 static_cast<unsigned>(std::max<std::size_t>(1, least)),
                                                 std::numeric_limits<unsigned>::max());
    for (const pcl::PointIndices& group : found) {
        std::vector<std::uint32_t>& own = groups.emplace_back(group.indices.begin(), group.indices.end());
        std::sort(own.begin(), own.end());
    }
    std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
        return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
    });
    return groups;
}

}  // namespace
}  // namespace lathelier::features

extern "C" {
extern const lathelier::features::SceneKernel lathelier_scene_kernel;
const lathelier::features::SceneKernel lathelier_scene_kernel{lathelier::features::planeByConsensus,
                                                              lathelier::features::groupsByDistance};
}
