// Planning of turning programs. One core.
#include <benchmark/benchmark.h>

#include "engine/cam/plan.h"
#include "engine/cam/reach.h"
#include "engine/cam/work_frame.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

Job neckJob()
{
    Job job = jobWith(neckRows(), 32, 150, {roughD55(), finishD55(), backV35(), blade(8, ToolUse::Groove, 2, 0.2, 18)});
    job.part_off = true;
    return job;
}

/// The curve of the finishing nose, back edge and all.
void BM_NoseCurve(benchmark::State& state)
{
    std::mt19937 random(1);
    std::vector<HeightContour> contours;
    for (int i = 0; i < 200; ++i) contours.push_back(heightContour(randomShaft(random)));
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(noseCurve(contours[i++ % contours.size()], {0.8, 30, 93}));
}
BENCHMARK(BM_NoseCurve)->Unit(benchmark::kMicrosecond);

void BM_Rest(benchmark::State& state)
{
    const Job job = neckJob();
    const WorkFrame frame = frameOf(job, *job.shaft);
    const std::vector<ToolReach> tools{reachOf(frame, job.tools[1])};
    for (auto _ : state) benchmark::DoNotOptimize(restOf(frame.contour, tools));
}
BENCHMARK(BM_Rest)->Unit(benchmark::kMicrosecond);

/// Rest operations tried on the stock among it; no text.
void BM_PlanClamping(benchmark::State& state)
{
    const Job job = neckJob();
    const Clamping clamping = wholeClamping(*job.shaft, job);
    for (auto _ : state) benchmark::DoNotOptimize(planSetup(clamping, barOf(clamping)));
}
BENCHMARK(BM_PlanClamping)->Unit(benchmark::kMillisecond);

/// Written, read again and checked.
void BM_PlanAndCheck(benchmark::State& state)
{
    const Job job = neckJob();
    for (auto _ : state) benchmark::DoNotOptimize(planned(job));
}
BENCHMARK(BM_PlanAndCheck)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier::cam

BENCHMARK_MAIN();
