// Deflection: a pass of 3000 steps, ten of them, the band of 200 samples, the map, the correction. One core but for the
// last two of the what-if.
#include <benchmark/benchmark.h>

#include "engine/core/parallel.h"
#include "engine/deflection/compensation.h"
#include "engine/deflection/what_if.h"

namespace lathelier::deflection {
namespace {

TurningSetup caseA(double step_mm)
{
    TurningSetup setup;
    setup.material.elastic.elastic_modulus_MPa = 210150;
    setup.material.elastic.poisson_ratio = 0.28;
    setup.material.cutting = {1748.5, 99.2, 703, 92.5};
    setup.tool.corner_radius_mm = 0.8;
    setup.tool.entering_angle_deg = 95;
    setup.chuck = {33000, 1e15, 6.87e7, 3e7};
    setup.tailstock = HoldingSprings{5500, 1e15, 0, 0};
    setup.step_mm = step_mm;
    return setup;
}

Shaft rod()
{
    Shaft shaft;
    shaft.segments = {{287.5, 34, 34, 0, {}, {}}};
    return shaft;
}

std::vector<ToolRun> passes(int count)
{
    std::vector<ToolRun> runs;
    runs.reserve(static_cast<std::size_t>(count));
    for (int i = 1; i <= count; ++i) {
        const double radius_mm = 17 - 3.0 * i / count;
        runs.push_back({ToolRun::Kind::TowardChuck, {{-2, radius_mm, 0.2, i}, {280, radius_mm, 0.2, i}}});
    }
    return runs;
}

/// 3000 steps in 280 mm.
void predictPasses(benchmark::State& state)
{
    const ThreadLimit one(1);
    const TurningSetup setup = caseA(280.0 / 3000);
    const Shaft stock = rod();
    const std::vector<ToolRun> runs = passes(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(predictDeflection(stock, runs, setup));
}
BENCHMARK(predictPasses)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);

void bandOf200Samples(benchmark::State& state)
{
    const TurningSetup setup = caseA(0.5);
    const WorkPlan plan = workPlan(rod(), passes(static_cast<int>(state.range(0))), setup);
    for (auto _ : state) benchmark::DoNotOptimize(errorBand(plan, setup));
}
BENCHMARK(bandOf200Samples)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond)->UseRealTime();

void mapOverDepthAndFeed(benchmark::State& state)
{
    const TurningSetup setup = caseA(0.5);
    const WorkPlan plan = workPlan(rod(), passes(1), setup);
    for (auto _ : state) benchmark::DoNotOptimize(deflectionMap(plan, setup));
}
BENCHMARK(mapOverDepthAndFeed)->Unit(benchmark::kMillisecond)->UseRealTime();

void correctPasses(benchmark::State& state)
{
    const TurningSetup setup = caseA(0.5);
    const Shaft stock = rod();
    const std::vector<ToolRun> runs = passes(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(compensate(stock, runs, setup));
}
BENCHMARK(correctPasses)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::deflection

BENCHMARK_MAIN();
