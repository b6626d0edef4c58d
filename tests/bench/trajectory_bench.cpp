// From a record in memory to its longitudinal section: averages of 20 × 200 angles, and 20 × 40 revolutions raw.
#include <benchmark/benchmark.h>

#include "engine/sample/sample_record.h"
#include "engine/trajectory/longitudinal.h"
#include "engine/trajectory/record_plan.h"
#include "engine/trajectory/section_signals.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {
namespace {

template <class Record>
std::vector<io::ProbeFile> filesOf(Record record)
{
    std::vector<io::ProbeFile> files(1);
    files[0].record = std::move(record);
    return files;
}

/// The practice rate: 6.5 kHz on each of five channels, 400 frames a revolution.
const std::vector<io::ProbeFile>& rawRecord()
{
    static const std::vector<io::ProbeFile> files = [] {
        sample::SpindleModel model = sample::sampleSpindle();
        model.rate_hz = 6500;
        model.channel_skew_s = 1 / (5 * model.rate_hz);
        return filesOf(sample::makeProbeRecord(model));
    }();
    return files;
}

void averaged20x200(benchmark::State& state)
{
    const std::vector<io::ProbeFile> files = filesOf(sample::makeAveragedRecord(sample::sampleSpindle()));
    for (auto _ : state) benchmark::DoNotOptimize(trajectory(files));
}

void raw20x40Revolutions(benchmark::State& state)
{
    for (auto _ : state) benchmark::DoNotOptimize(trajectory(rawRecord()));
}

void revolutionsOfTheRawRecord(benchmark::State& state)
{
    const auto& record = std::get<io::ProbeRecord>(rawRecord()[0].record);
    for (auto _ : state) {
        Notes notes;
        benchmark::DoNotOptimize(prepare(record, "record", {}, notes));
    }
}

void resamplingOfTheRawRecord(benchmark::State& state)
{
    const auto& record = std::get<io::ProbeRecord>(rawRecord()[0].record);
    Notes notes;
    const trajectory::PreparedRecord ready = prepare(record, "record", {}, notes);
    for (auto _ : state)
        benchmark::DoNotOptimize(resample(record, ready.clock, ready.map, ready.revolutions, ready.revolutions.all, 200,
                                          ready.channel_skew_s));
}

void longitudinalOf20Sections(benchmark::State& state)
{
    const trajectory::TrajectoryResult result =
        trajectory(filesOf(sample::makeAveragedRecord(sample::sampleSpindle())));
    for (auto _ : state) {
        Notes notes;
        benchmark::DoNotOptimize(longitudinalSection(result.sections, notes));
    }
}

BENCHMARK(averaged20x200)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(raw20x40Revolutions)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(revolutionsOfTheRawRecord)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(resamplingOfTheRawRecord)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(longitudinalOf20Sections)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace lathelier::trajectory

BENCHMARK_MAIN();
