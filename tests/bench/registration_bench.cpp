// Axis fit, shoulders, deviation and the whole comparison of two full scans of the shaft (732 000 points each).
#include <benchmark/benchmark.h>

#include "engine/registration/compare.h"
#include "engine/registration/revolution/meridian_line.h"
#include "engine/registration/revolution/revolution_deviation.h"
#include "engine/registration/statistics.h"
#include "engine/sample/sample.h"

namespace lathelier::registration {
namespace {

struct Scans {
    Scan reference;
    Scan copy;
    registration::TurnedPart reference_part;
    registration::TurnedPart copy_part;
};

const Scans& scans()
{
    static const Scans all = [] {
        Scans s;
        sample::ScannerModel scanner;
        s.reference = sample::scanShaft(sample::nominalShaft(), scanner);
        scanner.seed = 2;
        scanner.scan_T_part = Eigen::Translation3d(1, 1.2, 1) * Eigen::AngleAxisd(0.026, Eigen::Vector3d::UnitY());
        scanner.frame_T_scan = Eigen::Translation3d(9, -9, 9) * Eigen::AngleAxisd(0.17, Eigen::Vector3d::UnitX());
        s.copy = sample::scanShaft(sample::copiedShaft(), scanner);
        s.reference_part.fit = fitRevolution(s.reference.points_mm);
        s.copy_part.fit = fitRevolution(s.copy.points_mm);
        return s;
    }();
    return all;
}

void axisFit(benchmark::State& state)
{
    const Scans& s = scans();
    for (auto _ : state) benchmark::DoNotOptimize(fitRevolution(s.copy.points_mm));
}

void shoulders(benchmark::State& state)
{
    const Scans& s = scans();
    for (auto _ : state)
        benchmark::DoNotOptimize(
            findShoulders(s.reference.points_mm, s.reference_part.fit, s.copy.points_mm, s.copy_part.fit));
}

void registration(benchmark::State& state)
{
    const Scans& s = scans();
    for (auto _ : state) {
        registration::TurnedPart reference{fitRevolution(s.reference.points_mm), {}};
        registration::TurnedPart copy{fitRevolution(s.copy.points_mm), {}};
        registration::ShoulderPair pair =
            findShoulders(s.reference.points_mm, reference.fit, s.copy.points_mm, copy.fit);
        reference.shoulders = std::move(pair.reference);
        copy.shoulders = std::move(pair.copy);
        benchmark::DoNotOptimize(alignRevolution(reference, copy, registration::InitialPose::Auto));
    }
}

void deviation(benchmark::State& state)
{
    const Scans& s = scans();
    for (auto _ : state) {
        const registration::MeridianLine line(s.reference_part, s.reference.points_mm);
        const std::vector<float> found = meridianDeviation(s.reference_part, line, s.reference.points_mm, 1);
        benchmark::DoNotOptimize(found.data());
    }
}

void statistics(benchmark::State& state)
{
    const Scans& s = scans();
    const registration::MeridianLine line(s.reference_part, s.reference.points_mm);
    std::vector<float> values = meridianDeviation(s.reference_part, line, s.reference.points_mm, 1);
    std::erase_if(values, [](float v) { return v != v; });
    for (auto _ : state) {
        benchmark::DoNotOptimize(summarise(values));
        benchmark::DoNotOptimize(histogramOf(values));
    }
}

void wholeComparison(benchmark::State& state)
{
    const Scans& s = scans();
    for (auto _ : state) benchmark::DoNotOptimize(compare(s.reference, s.copy));
}

/// 0.27° × 0.025 mm: what a fine scanner delivers.
void wholeComparisonOfTenMillion(benchmark::State& state)
{
    sample::ScannerModel scanner;
    scanner.row_pitch_mm = 0.025;
    scanner.angle_step_deg = 0.27;
    const Scan reference = sample::scanShaft(sample::nominalShaft(), scanner);
    scanner.seed = 2;
    scanner.frame_T_scan = Eigen::Translation3d(9, -9, 9) * Eigen::AngleAxisd(0.17, Eigen::Vector3d::UnitX());
    const Scan copy = sample::scanShaft(sample::copiedShaft(), scanner);
    for (auto _ : state) benchmark::DoNotOptimize(compare(reference, copy));
    state.counters["points"] = static_cast<double>(reference.points_mm.size());
}

BENCHMARK(axisFit)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(shoulders)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(registration)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(deviation)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(statistics)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(wholeComparison)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(wholeComparisonOfTenMillion)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Iterations(1);

}  // namespace
}  // namespace lathelier::registration

BENCHMARK_MAIN();
