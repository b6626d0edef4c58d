// Recognition of the paper's shaft: 732 000 points to the table; the CAD of it.
#include <benchmark/benchmark.h>

#include "engine/cad/step_reader.h"
#include "engine/cad/step_writer.h"
#include "engine/features/recognition.h"
#include "engine/sample/sample.h"

namespace lathelier {
namespace {

const Scan& scan()
{
    static const Scan made = [] {
        sample::ScannerModel scanner;
        scanner.scan_T_part = Eigen::AngleAxisd(0.007, Eigen::Vector3d::UnitX());
        return sample::scanShaft(sample::nominalShaft(), scanner);
    }();
    return made;
}

void recognition(benchmark::State& state)
{
    scan();
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(features::recognize(scan(), {}));
}
BENCHMARK(recognition)->Unit(benchmark::kMillisecond)->UseRealTime();

void stepOut(benchmark::State& state)
{
    const Shaft shaft = features::recognize(scan(), {}).shaft;
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(cad::stepText(shaft, {}));
}
BENCHMARK(stepOut)->Unit(benchmark::kMillisecond);

void stepIn(benchmark::State& state)
{
    const std::string text = cad::stepText(features::recognize(scan(), {}).shaft, {});
    Notes notes;
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(cad::readStep(text, notes));
}
BENCHMARK(stepIn)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lathelier

BENCHMARK_MAIN();
