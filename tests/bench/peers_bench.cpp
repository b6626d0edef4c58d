// General registration beside the peers that are installed, in one run on the same bracket: 10° and 5 mm away, σ 0.05
// mm. PCL and Open3D are linked when they were found; CloudCompare is run when it is in the PATH. Peers start from the
// poses as they are (they have no start of their own); what they need besides (normals, trees) counts.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "engine/core/parallel.h"
#include "engine/registration/general/general.h"
#include "engine/sample/sample.h"

#ifdef LATHELIER_WITH_PCL
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_types.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#endif
#ifdef LATHELIER_WITH_OPEN3D
#include <open3d/Open3D.h>
#endif

namespace {

using namespace lathelier;

constexpr double sigma_mm = 0.05;

Eigen::Isometry3d copyPose()
{
    return Eigen::Translation3d(3, -3, 2.65) *
           Eigen::AngleAxisd(10 * std::numbers::pi / 180, Eigen::Vector3d(1, 2, -2).normalized());
}

struct Pair {
    Scan reference;
    Scan copy;
};

Pair makePair(std::size_t count)
{
    return {sample::scanBracket(count, sigma_mm, Eigen::Isometry3d::Identity(), 1),
            sample::scanBracket(count, sigma_mm, copyPose(), 2)};
}

void showError(benchmark::State& state, const Eigen::Isometry3d& reference_T_copy)
{
    const Eigen::Isometry3d error = reference_T_copy * copyPose();
    const Eigen::Vector3d middle(40, 40, 30);
    state.counters["points"] = static_cast<double>(state.range(0));
    state.counters["translation_um"] = 1000 * (error * middle - middle).norm();
    state.counters["rotation_mdeg"] = 1000 * Eigen::AngleAxisd(error.linear()).angle() * 180 / std::numbers::pi;
}

void lathelierPlane(benchmark::State& state)
{
    const ThreadLimit limit(2);
    const Pair scans = makePair(static_cast<std::size_t>(state.range(0)));
    registration::Alignment a;
    for (auto _ : state)
        a = alignGeneral(scans.reference, scans.copy, registration::CompareMethod::Plane,
                         registration::InitialPose::Auto);
    showError(state, a.reference_T_copy);
}
BENCHMARK(lathelierPlane)->Arg(60000)->Arg(732000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

#ifdef LATHELIER_WITH_PCL
pcl::PointCloud<pcl::PointNormal>::Ptr toPcl(const Scan& scan)
{
    pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
    for (const Eigen::Vector3d& p : scan.points_mm) {
        pcl::PointNormal q;
        q.getVector3fMap() = p.cast<float>();
        cloud->push_back(q);
    }
    return cloud;
}

void addNormals(const pcl::PointCloud<pcl::PointNormal>::Ptr& cloud)
{
    pcl::NormalEstimationOMP<pcl::PointNormal, pcl::PointNormal> normals(2);
    normals.setInputCloud(cloud);
    normals.setKSearch(20);
    normals.compute(*cloud);
}

template <class Registration>
void runPcl(benchmark::State& state, bool with_normals)
{
    const Pair scans = makePair(static_cast<std::size_t>(state.range(0)));
    const auto reference = toPcl(scans.reference);
    const auto copy = toPcl(scans.copy);
    Eigen::Isometry3d found = Eigen::Isometry3d::Identity();
    for (auto _ : state) {
        if (with_normals) {
            addNormals(reference);
            addNormals(copy);
        }
        Registration registration;
        registration.setInputSource(copy);
        registration.setInputTarget(reference);
        registration.setMaximumIterations(50);
        registration.setMaxCorrespondenceDistance(20);
        registration.setTransformationEpsilon(1e-10);
        pcl::PointCloud<pcl::PointNormal> moved;
        registration.align(moved);
        found.matrix() = registration.getFinalTransformation().template cast<double>();
        state.counters["converged"] = registration.hasConverged();
    }
    found.linear() = Eigen::Quaterniond(found.linear()).normalized().toRotationMatrix();
    showError(state, found);
}

void pclPointToPlane(benchmark::State& state)
{
    runPcl<pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal>>(state, true);
}

void pclGicp(benchmark::State& state)
{
    runPcl<pcl::GeneralizedIterativeClosestPoint<pcl::PointNormal, pcl::PointNormal>>(state, false);
}

BENCHMARK(pclPointToPlane)->Arg(60000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(pclGicp)->Arg(60000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
#endif

#ifdef LATHELIER_WITH_OPEN3D
void open3dPointToPlane(benchmark::State& state)
{
    const Pair scans = makePair(static_cast<std::size_t>(state.range(0)));
    Eigen::Isometry3d found = Eigen::Isometry3d::Identity();
    for (auto _ : state) {
        open3d::geometry::PointCloud reference(scans.reference.points_mm);
        const open3d::geometry::PointCloud copy(scans.copy.points_mm);
        reference.EstimateNormals(open3d::geometry::KDTreeSearchParamKNN(20));
        const auto result = open3d::pipelines::registration::RegistrationICP(
            copy, reference, 20, Eigen::Matrix4d::Identity(),
            open3d::pipelines::registration::TransformationEstimationPointToPlane(),
            open3d::pipelines::registration::ICPConvergenceCriteria(1e-9, 1e-9, 50));
        found.matrix() = result.transformation_;
    }
    showError(state, found);
}
BENCHMARK(open3dPointToPlane)->Arg(60000)->Arg(732000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
#endif

bool isInPath(const std::string& program)
{
    return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

// Reading and writing files included: it has no other door.
void cloudCompare(benchmark::State& state)
{
    namespace fs = std::filesystem;
    if (!isInPath("CloudCompare")) {
        state.SkipWithError("CloudCompare is not installed");
        return;
    }
    const fs::path folder = fs::temp_directory_path() / "lathelier_peers_bench";
    fs::create_directories(folder);
    const Pair scans = makePair(static_cast<std::size_t>(state.range(0)));
    for (const auto& [name, scan] :
         {std::pair{"reference.xyz", &scans.reference}, std::pair{"copy.xyz", &scans.copy}}) {
        std::ofstream out(folder / name);
        out.precision(9);
        for (const Eigen::Vector3d& p : scan->points_mm) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    const std::string command =
        "cd '" + folder.string() +
        "' && QT_QPA_PLATFORM=offscreen CloudCompare -SILENT -AUTO_SAVE OFF -O copy.xyz -O reference.xyz"
        " -ICP > log.txt 2>&1";
    for (auto _ : state)
        if (std::system(command.c_str()) != 0) state.SkipWithError("CloudCompare failed");
    state.counters["points"] = static_cast<double>(state.range(0));
    fs::remove_all(folder);
}
BENCHMARK(cloudCompare)->Arg(732000)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
