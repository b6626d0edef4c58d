// A queue whose workers are killed: a series of small parts computed by a batch, and by workers of which 40 get SIGKILL
// at random moments before others end the work. Wanted: no part lost, none twice, none failed, an archive that is
// whole, the same bytes as those of the batch, and the bad parts found; else the benchmark is an error.
//
// All work is done in processes of their own: this one has no threads when it forks.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <random>
#include <thread>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/result_lines.h"
#include "engine/batch/batch.h"
#include "engine/batch/recipe_file.h"
#include "engine/cad/task/compare_task.h"
#include "engine/core/parallel.h"
#include "engine/io/file.h"
#include "engine/queue/queue.h"
#include "engine/queue/worker.h"
#include "engine/sample/series_sample.h"
#include "tests/killed_process.h"

namespace lathelier::queue {
namespace {

using archive::Access;
using archive::Archive;
using std::chrono::duration;
using std::chrono::steady_clock;

constexpr int killedWorkers = 40;
constexpr std::size_t workersBeside = 2;
constexpr std::uint64_t seedOfKills = 49;
constexpr double shareWhileKilling = 0.6;  ///< of the time that the batch took

const batch::Tasks& tasks()
{
    static const batch::Tasks all{&cad::compareTask()};
    return all;
}

double secondsSince(steady_clock::time_point begin)
{
    return duration<double>(steady_clock::now() - begin).count();
}

/// Errors by their text.
void require(bool holds, const std::string& otherwise)
{
    if (!holds) throw std::runtime_error(otherwise);
}

class Trial {
public:
    explicit Trial(int parts)
    {
        model_.parts = parts;
        require(endedWell(beginWork([this] { sample::writeSeries(folder_.path(), model_); })), "no series");
    }

    /// Into an archive. Returns the time of computing in seconds.
    double batch() const
    {
        const auto begin = steady_clock::now();
        require(endedWell(beginWork([this] {
                    batch::BatchSettings settings;
                    settings.folder = path("out");
                    settings.jobs = static_cast<int>(workersBeside);
                    batch::runBatch({path("parts")}, recipe(), settings);
                })),
                "the batch has no result");
        const double seconds = secondsSince(begin);
        Archive made = Archive::open(path("batch.archive"), Access::Create);
        const io::FileBytes bytes(path("out/results.jsonl"));
        const archive::ResultLines lines = archive::readResultLines(bytes.view());
        made.add(lines.evaluations, {}, lines.recipes);
        return seconds;
    }

    void enqueue() const
    {
        Archive made = Archive::open(location(), Access::Create);
        const std::vector<batch::Part> parts = batch::partsOf({path("parts")}, recipe());
        require(queue::enqueue(made, path("recipe.json"), recipe(), parts).queued == model_.parts,
                "not all are queued");
    }

    /// For about `seconds`, side by side, one after the other.
    void workAndKillAll(double seconds) const
    {
        const double mean_ms = 1000 * seconds * static_cast<double>(workersBeside) / killedWorkers;
        std::mt19937_64 random(seedOfKills);
        std::uniform_real_distribution<double> life_ms(0.1 * mean_ms, 1.9 * mean_ms);
        std::array<std::vector<std::chrono::milliseconds>, workersBeside> lives;
        for (std::size_t i = 0; i < killedWorkers; ++i)
            lives.at(i % workersBeside).emplace_back(static_cast<std::int64_t>(life_ms(random)));
        std::atomic<int> killed = 0;
        {
            std::vector<std::jthread> beside;
            beside.reserve(workersBeside);
            for (std::size_t k = 0; k < workersBeside; ++k)
                beside.emplace_back([&, k] {
                    for (std::size_t i = 0; i < lives.at(k).size(); ++i)
                        killed +=
                            workAndKill([&] { work(fmt::format("killed {}.{}", k, i), seconds); }, lives.at(k)[i]);
                });
        }
        require(killed == killedWorkers, "a worker ended before it was killed");
    }

    void workToTheEnd(double seconds) const
    {
        std::vector<pid_t> workers;
        workers.reserve(workersBeside);
        for (std::size_t k = 0; k < workersBeside; ++k)
            workers.push_back(beginWork([&] { work(fmt::format("last {}", k), seconds); }));
        bool all = true;
        for (const pid_t worker : workers) all = endedWell(worker) && all;
        require(all, "a worker has failed");
    }

    std::int64_t done() const { return state().done; }

    void requireSound() const
    {
        const QueueState left = state();
        require(left.done == model_.parts && left.failed == 0 && left.waiting == 0 && left.running == 0,
                fmt::format("{} of {} parts done, {} failed", left.done, model_.parts, left.failed));
        const Archive queued = Archive::open(location(), Access::Read);
        const archive::Verification made = queued.verify();
        require(!made.broken, "the archive is not whole");
        require(made.checked() == model_.parts, "a part is there twice, or is missing");
        require(linesOf(queued) == linesOf(Archive::open(path("batch.archive"), Access::Read)),
                "the batch has given other bytes");
        std::vector<std::string> bad;
        for (const int number : sample::badParts(model_)) bad.push_back(fmt::format("part-{:04}.ply", number + 1));
        require(outOfTolerance(queued) == bad, "the bad parts are others");
    }

private:
    std::string path(const char* name) const { return folder_.path() + "/" + name; }
    std::string location() const { return path("queue.archive"); }
    batch::Recipe recipe() const { return batch::loadRecipe(path("recipe.json"), tasks()).recipe; }

    void work(const std::string& worker, double seconds_of_kills) const
    {
        const ThreadLimit limit(1);
        WorkSettings settings;
        settings.location = location();
        settings.worker = worker;
        // A part is lost twice at most while workers are killed: after the third time it would fail, and rightly.
        settings.lost_after_s = seconds_of_kills / 2;
        queue::work(settings, tasks(), {});
    }

    QueueState state() const
    {
        Archive queued = Archive::open(location(), Access::Read);
        return queue::stateOf(queued);
    }

    static std::string linesOf(const Archive& archive)
    {
        std::string lines;
        archive.exportLines([&lines](std::string_view line) { lines += line; }, true);
        return lines;
    }

    static std::vector<std::string> outOfTolerance(const Archive& archive)
    {
        std::vector<std::string> names;
        for (const archive::Entry& entry : archive.list({.verdict = Verdict::Fail, .most = 0}))
            names.push_back(entry.file);
        std::sort(names.begin(), names.end());
        return names;
    }

    io::PartFolder folder_;
    sample::SeriesModel model_;
};

/// Argument: parts.
void queueWithKilledWorkers(benchmark::State& state)
{
    const auto parts = static_cast<int>(state.range(0));
    for (auto _ : state) {
        try {
            const Trial trial(parts);
            const double batch_s = trial.batch();
            trial.enqueue();
            const double killing_s = shareWhileKilling * batch_s;
            const auto begin = steady_clock::now();
            trial.workAndKillAll(killing_s);
            state.counters["done_by_killed"] = static_cast<double>(trial.done());
            trial.workToTheEnd(killing_s);
            const double queue_s = secondsSince(begin);
            state.SetIterationTime(queue_s);
            trial.requireSound();
            state.counters["batch_s"] = batch_s;
            state.counters["killed"] = killedWorkers;
            state.counters["parts_per_hour"] = 3600 * parts / queue_s;
        } catch (const std::exception& failure) {
            state.SkipWithError(failure.what());
            break;
        }
    }
}
BENCHMARK(queueWithKilledWorkers)->Arg(200)->Arg(2000)->Iterations(1)->UseManualTime()->Unit(benchmark::kSecond);

}  // namespace
}  // namespace lathelier::queue

BENCHMARK_MAIN();
