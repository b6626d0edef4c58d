// Jobs side by side whose results leave in the order of the parts.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::batch {

/// Calls work(i) for each i below `count` on `jobs` threads and leave(i, result) in the order of i, one at a time, from
/// any of them. No more than a few results for each job wait for one before them. Work that needs what those before it
/// know asks turn(i, decide): `decide` of all are called in the order of i. The first exception of any ends it and
/// comes out of run(), after the work under way.
template <class Result>
class OrderedJobs {
public:
    OrderedJobs(std::size_t count, std::size_t jobs) : count_(count), slots_(jobs * resultsForEachJob) {}

    using Work = std::function<Result(std::size_t)>;
    using Leave = std::function<void(std::size_t, Result&)>;

    /// `runJobs(jobs, body)` calls body on so many threads and returns when all have ended.
    template <class RunJobs>
    void run(std::size_t jobs, const RunJobs& runJobs, const Work& work, const Leave& leave)
    {
        runJobs(jobs, [&] { this->job(work, leave); });
        if (failure_) std::rethrow_exception(failure_);
    }

    /// Throws Ended when another job has failed: there is nothing left to decide.
    struct Ended {};

    template <class Decide>
    void turn(std::size_t place, const Decide& decide)
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return failure_ || turn_ == place; });
        if (failure_) throw Ended();
        decide();
        ++turn_;
        changed_.notify_all();
    }

private:
    static constexpr std::size_t resultsForEachJob = 8;

    void job(const Work& work, const Leave& leave)
    {
        try {
            while (const auto place = next()) put(*place, work(*place), leave);
        } catch (const Ended&) {
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            changed_.notify_all();
        }
    }

    std::optional<std::size_t> next()
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return failure_ || next_ == count_ || next_ < left_ + slots_.size(); });
        if (failure_ || next_ == count_) return std::nullopt;
        return next_++;
    }

    void put(std::size_t place, Result result, const Leave& leave)
    {
        const std::lock_guard lock(mutex_);
        slots_[place % slots_.size()] = std::move(result);
        for (; left_ < count_; ++left_) {
            std::optional<Result>& slot = slots_[left_ % slots_.size()];
            if (!slot) break;
            leave(left_, *slot);
            slot.reset();
        }
        changed_.notify_all();
    }

    std::size_t count_;
    std::vector<std::optional<Result>> slots_;  ///< results that wait, by place modulo their number
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t next_ = 0;  ///< place that is taken next
    std::size_t turn_ = 0;  ///< place that decides next
    std::size_t left_ = 0;  ///< results that have left
    std::exception_ptr failure_;
};

/// Calls `body` on `jobs` threads, this one among them; on fewer where the system has no more.
void onThreads(std::size_t jobs, const std::function<void()>& body);

}  // namespace lathelier::batch
