// All four reference circles of a turned profile, with and without the certificate, beside CGAL and ALGLIB where
// installed; cylindricity of clouds.
#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/form/circle/circles.h"
#include "engine/form/cylinder/cylindricity.h"
#include "tests/peers/circle_peers.h"

namespace lathelier::form {
namespace {

/// R = 25 mm, 50 µm off centre, lobes of some µm and noise of 0.8 µm.
std::vector<Eigen::Vector2d> turned(std::size_t count)
{
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        const double r = 25 + 0.003 * std::cos(2 * t + 0.4) + 0.002 * std::cos(3 * t + 1) +
                         0.001 * std::cos(5 * t + 2) + 0.0005 * std::cos(15 * t) + 0.0008 * randomNormal(1, 0, i);
        points.emplace_back(0.03 + r * std::cos(t), 0.04 + r * std::sin(t));
    }
    return points;
}

/// A pure lobe form: many points touch at once, the hardest case for the exchange.
std::vector<Eigen::Vector2d> lobed(std::size_t count)
{
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        const double r = 25 + 0.003 * std::cos(5 * t);
        points.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    return points;
}

void fit(benchmark::State& state, const std::vector<Eigen::Vector2d>& points)
{
    form::CircleOptions options;
    options.certify = state.range(1) != 0;
    double gap_um = 0;
    for (auto _ : state) {
        const form::ReferenceCircles circles = fitCircles(points, options);
        gap_um = circles.MZCI.certified_gap_um.value_or(0);
        benchmark::DoNotOptimize(circles.MZCI.RONt_um);
    }
    state.counters["gap_um"] = gap_um;
}

void turnedProfile(benchmark::State& state)
{
    fit(state, turned(static_cast<std::size_t>(state.range(0))));
}

void lobedProfile(benchmark::State& state)
{
    fit(state, lobed(static_cast<std::size_t>(state.range(0))));
}

void cylinderCloud(benchmark::State& state)
{
    std::vector<Eigen::Vector3d> points;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(state.range(0)); ++i) {
        const double t = 2 * std::numbers::pi * randomUniform(1, 0, i), z = 80 * randomUniform(1, 1, i);
        const double r = 25 + 0.003 * std::cos(3 * t) + 0.0008 * randomNormal(1, 2, i);
        points.emplace_back(r * std::cos(t), r * std::sin(t), z);
    }
    for (auto _ : state) benchmark::DoNotOptimize(cylindricity(points).MZCY.CYLt_um);
}

#ifdef LATHELIER_WITH_CGAL
void cgalEnclosing(benchmark::State& state)
{
    const auto points = turned(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(peers::cgalEnclosing(points).outer);
}

void cgalAnnulus(benchmark::State& state)
{
    const auto points = turned(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(peers::cgalAnnulus(points).outer);
}

BENCHMARK(cgalEnclosing)->Arg(200)->Arg(3600)->Unit(benchmark::kMillisecond);
BENCHMARK(cgalAnnulus)->Arg(200)->Arg(3600)->Unit(benchmark::kMillisecond);
#endif

#ifdef LATHELIER_WITH_ALGLIB
void alglibMinimumZone(benchmark::State& state)
{
    const auto points = turned(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(peers::alglibMinimumZone(points).outer);
}

BENCHMARK(alglibMinimumZone)->Arg(200)->Arg(3600)->Unit(benchmark::kMillisecond);
#endif

BENCHMARK(cylinderCloud)->Arg(4000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(turnedProfile)->ArgsProduct({{200, 3600, 36000, 1000000}, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(lobedProfile)->ArgsProduct({{200, 3600, 36000, 1000000}, {0, 1}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::form

BENCHMARK_MAIN();
