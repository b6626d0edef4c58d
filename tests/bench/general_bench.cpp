// Nearest points, signed deviation and alignment of parts of any shape, at the size of a real scan: 732 000 points.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/registration/general/general.h"
#include "engine/registration/neighbours/cloud_distance.h"
#include "engine/registration/surface/surface_deviation.h"
#include "engine/sample/sample.h"

namespace {

using namespace lathelier;
using namespace lathelier::registration;

constexpr std::size_t points = 732000;
constexpr double sigma_mm = 0.05;

const Eigen::Isometry3d& copyPose()
{
    static const Eigen::Isometry3d pose =
        Eigen::Translation3d(3, -3, 2.65) *
        Eigen::AngleAxisd(10 * std::numbers::pi / 180, Eigen::Vector3d(1, 2, -2).normalized());
    return pose;
}

const Scan& reference()
{
    static const Scan scan = sample::scanBracket(points, sigma_mm, Eigen::Isometry3d::Identity(), 1);
    return scan;
}

const Scan& alignedCopy()
{
    static const Scan scan = sample::scanBracket(points, sigma_mm, Eigen::Isometry3d::Identity(), 2);
    return scan;
}

const Scan& movedCopy()
{
    static const Scan scan = sample::scanBracket(points, sigma_mm, copyPose(), 2);
    return scan;
}

const Scan& shaftScan(std::uint64_t seed)
{
    static const auto make = [](std::uint64_t s) {
        sample::ScannerModel scanner;
        scanner.seed = s;
        return sample::scanShaft(sample::nominalShaft(), scanner);
    };
    static const Scan first = make(1);
    static const Scan second = make(2);
    return seed == 1 ? first : second;
}

void nearestDistancesOfShafts(benchmark::State& state)
{
    const ThreadLimit limit(2);
    const Scan& a = shaftScan(1);
    const Scan& b = shaftScan(2);
    for (auto _ : state) benchmark::DoNotOptimize(nearestDistances(a.points_mm, b.points_mm, 1));
}

void deviationFromCloud(benchmark::State& state)
{
    const ThreadLimit limit(2);
    const Scan& a = reference();
    const Scan& b = alignedCopy();
    for (auto _ : state) benchmark::DoNotOptimize(surfaceDeviation(a, b.points_mm, 1));
}

void deviationFromMesh(benchmark::State& state)
{
    const ThreadLimit limit(2);
    const Scan mesh = sample::shaftMesh(sample::nominalShaft(), 8000);
    const Scan& b = shaftScan(2);
    for (auto _ : state) benchmark::DoNotOptimize(surfaceDeviation(mesh, b.points_mm, 1));
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void align(benchmark::State& state, const Scan& onto)
{
    const ThreadLimit limit(2);
    const Scan& copy = movedCopy();
    registration::Alignment a;
    for (auto _ : state)
        a = alignGeneral(onto, copy, registration::CompareMethod::Plane, registration::InitialPose::Auto);
    const Eigen::Isometry3d error = a.reference_T_copy * copyPose();
    const Eigen::Vector3d middle(40, 40, 30);
    state.counters["translation_um"] = 1000 * (error * middle - middle).norm();
    state.counters["rotation_mdeg"] = 1000 * Eigen::AngleAxisd(error.linear()).angle() * 180 / std::numbers::pi;
    state.counters["iterations"] = a.iterations;
    state.counters["converged"] = a.converged;
}

void alignToCloud(benchmark::State& state)
{
    align(state, reference());
}

void alignToMesh(benchmark::State& state)
{
    align(state, sample::bracketMesh());
}

// All that a comparison computes: one surface for alignment and deviation.
void alignAndMeasure(benchmark::State& state)
{
    const ThreadLimit limit(2);
    const Scan& onto = reference();
    const Scan& copy = movedCopy();
    for (auto _ : state) {
        const registration::GeneralReference prepared = prepareReference(onto);
        const registration::Alignment a =
            alignGeneral(prepared, copy, registration::CompareMethod::Plane, registration::InitialPose::Auto);
        std::vector<Eigen::Vector3d> moved = copy.points_mm;
        for (Eigen::Vector3d& p : moved) p = a.reference_T_copy * p;
        benchmark::DoNotOptimize(surfaceDeviation(prepared, moved, 1));
        benchmark::DoNotOptimize(nearestDistances(onto.points_mm, moved, 1));
    }
}

BENCHMARK(nearestDistancesOfShafts)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(deviationFromCloud)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(deviationFromMesh)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(alignAndMeasure)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(alignToCloud)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(alignToMesh)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
