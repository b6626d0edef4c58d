// A recipe over a series: comparisons of scans of 100 000 points for each hour and core, with one job and with two.
// Wanted: 3000 for each hour and core, and twice as many with two jobs within 10 %. The time of the processor is that
// of all threads, so that other work on the machine does not count.
#include <benchmark/benchmark.h>

#include <ctime>
#include <filesystem>

#include "engine/batch/batch.h"
#include "engine/batch/recipe_file.h"
#include "engine/cad/task/compare_task.h"
#include "engine/core/parallel.h"
#include "engine/io/file.h"
#include "engine/sample/series_sample.h"

namespace {

using namespace lathelier;

constexpr int pointsOfScan = 100'000;
constexpr int partsOfSeries = 16;

double processorTime_s()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

const std::string& seriesFolder()
{
    static const io::PartFolder folder;
    static const bool made = [] {
        sample::SeriesModel model;
        model.parts = partsOfSeries;
        model.points = pointsOfScan;
        sample::writeSeries(folder.path(), model);
        return true;
    }();
    static_cast<void>(made);
    return folder.path();
}

void BM_compare_series(benchmark::State& state)
{
    const auto jobs = static_cast<int>(state.range(0));
    const ThreadLimit limit(jobs);
    const std::string& folder = seriesFolder();
    const batch::Recipe recipe = batch::loadRecipe(folder + "/recipe.json", {&cad::compareTask()}).recipe;
    batch::BatchSettings settings;
    settings.folder = folder + "/out";
    settings.jobs = jobs;
    double processor_s = 0;
    for (auto _ : state) {
        state.PauseTiming();
        std::filesystem::remove_all(settings.folder);
        state.ResumeTiming();
        const double begin_s = processorTime_s();
        const batch::BatchResult result = batch::runBatch({folder + "/parts"}, recipe, settings);
        processor_s += processorTime_s() - begin_s;
        if (result.computed != partsOfSeries) state.SkipWithError("a part has no answer");
    }
    constexpr double hour_s = 3600;
    const double parts = static_cast<double>(state.iterations()) * partsOfSeries;
    state.counters["per_hour_of_processor"] = hour_s * parts / processor_s;
    state.counters["per_hour"] = benchmark::Counter(hour_s * parts, benchmark::Counter::kIsRate);
}
BENCHMARK(BM_compare_series)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
