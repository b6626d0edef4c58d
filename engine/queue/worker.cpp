#include "engine/queue/worker.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/batch/recipe_file.h"
#include "engine/core/failure.h"
#include "engine/queue/queue.h"
#include "engine/queue/queue_codes.h"

namespace lathelier::queue {
namespace {

using std::chrono::duration;

constexpr double beatsPerLoss = 4;    // a sign of life may be late three times
constexpr double betweenLooks_s = 1;  // at an empty queue

/// Signs of life from a thread and a connection of its own while a part is computed.
class Heartbeat {
public:
    Heartbeat(const WorkSettings& settings, Job job)
        : settings_(settings), job_(std::move(job)), thread_([this](const std::stop_token& stop) { run(stop); })
    {
    }
    Heartbeat(const Heartbeat&) = delete;
    Heartbeat& operator=(const Heartbeat&) = delete;
    ~Heartbeat() = default;  // the thread stops and is joined

private:
    void run(const std::stop_token& stop)
    {
        std::mutex mutex;
        std::condition_variable_any wake;
        std::unique_lock lock(mutex);
        const auto next = duration<double>(settings_.lost_after_s / beatsPerLoss);
        while (!wake.wait_for(lock, stop, next, [&stop] { return stop.stop_requested(); })) {
            try {
                if (!archive_)
                    archive_ = std::make_unique<archive::Archive>(
                        archive::Archive::open(settings_.location, archive::Access::Write));
                beat(*archive_, job_, settings_.worker);
            } catch (const std::exception&) {
                archive_.reset();  // the next sign goes over a new connection
            }
        }
    }

    const WorkSettings& settings_;
    Job job_;
    std::unique_ptr<archive::Archive> archive_;  ///< of the thread
    std::jthread thread_;                        ///< the last member: it uses the others
};

/// Recipes that were met so far, ready to compute.
class Recipes {
public:
    Recipes(const batch::Tasks& tasks, const batch::CompleteFrom& complete, Progress progress)
        : tasks_(tasks), complete_(complete), progress_(std::move(progress))
    {
    }

    struct Ready {
        batch::Recipe recipe;
        archive::ArchivedRecipe archived;
        std::unique_ptr<batch::PartRun> run;
    };

    /// Errors of loadRecipe() and requireUnchanged(); queueRecipeChanged.
    Ready& of(const Job& job)
    {
        if (const auto known = ready_.find(job.recipe_path);
            known != ready_.end() && known->second->archived.sha256 == job.recipe_sha256)
            return *known->second;
        auto made = std::make_unique<Ready>();
        made->recipe = batch::loadRecipe(job.recipe_path, tasks_, progress_).recipe;
        batch::requireUnchanged(made->recipe, progress_);
        const std::string identity = batch::identityOf(made->recipe);
        if (identity != job.recipe_sha256)
            throw Error(errors::queueRecipeChanged,
                        {{"path", job.recipe_path}, {"found", identity}, {"expected", job.recipe_sha256}});
        made->archived = {identity,
                          batch::contentOf(made->recipe).dump(-1, ' ', false, Json::error_handler_t::replace)};
        made->run = std::make_unique<batch::PartRun>(made->recipe, complete_, progress_);
        return *(ready_[job.recipe_path] = std::move(made));
    }

private:
    const batch::Tasks& tasks_;
    const batch::CompleteFrom& complete_;
    Progress progress_;
    std::map<std::string, std::unique_ptr<Ready>> ready_;
};

/// The part as it was queued.
archive::Evaluation begun(const Job& job, const batch::PartRun& run)
{
    archive::Evaluation evaluation = run.begin(job.part);
    if (evaluation.key() != job.key) throw Error(errors::queuePartChanged, {{"path", job.part.name()}});
    return evaluation;
}

class Working {
public:
    Working(const WorkSettings& settings, const batch::Tasks& tasks, const batch::CompleteFrom& complete,
            const Progress& progress)
        : settings_(settings),
          progress_(progress),
          archive_(archive::Archive::open(settings.location, archive::Access::Write, progress.quiet())),
          recipes_(tasks, complete, progress.quiet())
    {
    }

    Worked run()
    {
        for (;;) {
            progress_.check();
            const std::optional<Job> job = take(archive_, settings_.worker, settings_.lost_after_s);
            if (job)
                compute(*job);
            else if (!waitForMore())
                return done_;
        }
    }

private:
    void compute(const Job& job)
    {
        try {
            const Heartbeat heartbeat(settings_, job);
            Recipes::Ready& ready = recipes_.of(job);
            batch::PartRun::Answer answer = ready.run->answer(job.part, begun(job, *ready.run), false);
            if (answer.error && !answer.is_lasting) return putBack(job, *answer.error);
            const archive::Added added =
                archive_.add({answer.evaluation}, settings_.attestation, {ready.archived}, progress_.quiet());
            done_.already_there += added.already_there;
            if (answer.error) {
                ++done_.refused;
                fail(archive_, job, settings_.worker, *answer.error);
            } else {
                ++done_.computed;
                finish(archive_, job, settings_.worker);
            }
        } catch (const Cancelled&) {
            // This connection waits for nothing any more.
            archive::Archive archive = archive::Archive::open(settings_.location, archive::Access::Write);
            giveBack(archive, job, settings_.worker);
            throw;
        } catch (const Error& error) {
            putBack(job, error);
        }
    }

    void putBack(const Job& job, const Error& error)
    {
        ++done_.put_back;
        retryLater(archive_, job, settings_.worker, error);
    }

    /// False: no part waits and no worker has one.
    bool waitForMore()
    {
        if (!settings_.waits && isIdle(archive_)) return false;
        progress_.part(0, 1, LT_TEXT("Engine", "Waiting for parts")).report(0);
        constexpr int looksAtStop = 10;
        for (int i = 0; i < looksAtStop; ++i) {
            progress_.check();
            std::this_thread::sleep_for(duration<double>(betweenLooks_s / looksAtStop));
        }
        return true;
    }

    const WorkSettings& settings_;
    Progress progress_;
    archive::Archive archive_;
    Recipes recipes_;
    Worked done_;
};

}  // namespace

std::string nameOfThisWorker()
{
    char host[256] = "";
    ::gethostname(host, sizeof host - 1);
    return std::string(host) + ":" + std::to_string(::getpid());
}

Worked work(const WorkSettings& settings, const batch::Tasks& tasks, const batch::CompleteFrom& complete,
            const Progress& progress)
{
    return Working(settings, tasks, complete, progress).run();
}

}  // namespace lathelier::queue
