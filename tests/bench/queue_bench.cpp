// A series over a queue whose workers are killed: 2000 scans, 40 workers killed at random moments, two that finish.
// Wanted: nothing is lost or doubled, and the canonical export is byte-equal to that of a plain batch.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "engine/archive/archive.h"
#include "engine/archive/result_lines.h"
#include "engine/batch/batch.h"
#include "engine/batch/recipe_file.h"
#include "engine/cad/task/compare_task.h"
#include "engine/core/random.h"
#include "engine/io/file.h"
#include "engine/queue/queue.h"
#include "engine/queue/worker.h"
#include "engine/sample/series_sample.h"
#include "tests/killed_process.h"

namespace {

using namespace lathelier;

constexpr int kills = 40;
constexpr std::int64_t badParts = 3;
constexpr double shortest_ms = 100;
constexpr double longest_ms = 1500;

const batch::Tasks& tasks()
{
    static const batch::Tasks all{&cad::compareTask()};
    return all;
}

/// In a process of its own, so that this one has no threads when it forks workers. False: it failed.
bool apart(const std::function<void()>& work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            work();
        } catch (...) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void workOn(const std::string& location)
{
    queue::WorkSettings settings;
    settings.location = location;
    settings.worker = queue::nameOfThisWorker();
    settings.lost_after_s = 2;
    queue::work(settings, tasks(), {});
}

std::string canonical(const archive::Archive& archive)
{
    std::string lines;
    archive.exportLines([&](std::string_view line) { lines.append(line).append("\n"); }, true);
    return lines;
}

void BM_killed_workers(benchmark::State& state)
{
    const auto parts = static_cast<int>(state.range(0));
    for (auto _ : state) {
        const io::PartFolder scratch;
        const std::string folder = scratch.path();
        const std::string location = folder + "/queue.archive";
        const std::string recipe = folder + "/recipe.json";
        const bool is_queued = apart([&] {
            sample::SeriesModel model;
            model.parts = parts;
            sample::writeSeries(folder, model);
            archive::Archive made = archive::Archive::open(location, archive::Access::Create);
            const batch::Recipe read = batch::loadRecipe(recipe, tasks()).recipe;
            queue::enqueue(made, recipe, read, batch::partsOf({folder + "/parts"}, read));
        });
        if (!is_queued) return state.SkipWithError("the parts could not be queued");
        int killed = 0;
        for (int i = 0; i < kills; ++i) {
            const double share = randomUniform(49, 0, static_cast<std::uint64_t>(i));
            const auto life = static_cast<std::int64_t>(shortest_ms + share * (longest_ms - shortest_ms));
            killed += workAndKill([&] { workOn(location); }, std::chrono::milliseconds(life)) ? 1 : 0;
        }
        if (!apart([&] { workOn(location); })) return state.SkipWithError("the rest could not be computed");
        archive::Archive queued = archive::Archive::open(location, archive::Access::Write);
        const queue::QueueState ended = queue::stateOf(queued);
        if (ended.done != parts || ended.failed != 0) return state.SkipWithError("a part is lost or failed");
        if (queued.verify().broken) return state.SkipWithError("the chain is broken");
        batch::BatchSettings settings;
        settings.folder = folder + "/out";
        settings.jobs = 2;
        const batch::BatchResult plain =
            batch::runBatch({folder + "/parts"}, batch::loadRecipe(recipe, tasks()).recipe, settings);
        if (plain.verdicts[1] != badParts) return state.SkipWithError("the bad parts were not found");
        const io::FileBytes results(plain.results_file);
        const archive::ResultLines lines = archive::readResultLines(results.view());
        archive::Archive other = archive::Archive::open(folder + "/plain.archive", archive::Access::Create);
        other.add(lines.evaluations, {}, lines.recipes);
        if (canonical(queued) != canonical(other)) return state.SkipWithError("the exports differ");
        state.counters["killed"] = killed;
    }
}
BENCHMARK(BM_killed_workers)->Arg(2000)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
