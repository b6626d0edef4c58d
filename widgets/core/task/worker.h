// Latest job wins: one background thread that computes the newest request and drops what has become stale.
// Pure C++ on purpose: no Qt, so that it runs under ThreadSanitizer.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <variant>

#include "engine/core/error.h"
#include "engine/core/progress.h"

namespace lathelier {

/// Owns a thread. request() replaces a waiting job and stops a running one; the owner polls progress() and take()
/// (a panel does so every 5 ms at first, later 30 times a second). Every member may be called from any thread. The
/// destructor stops the running job and waits for it, which takes as long as the engine needs to notice (at most 20 ms
/// by its rule).
class Worker {
public:
    /// Computes the answer; throws Error, Cancelled or whatever the standard library throws.
    using Job = std::function<std::shared_ptr<const void>(const Progress&)>;

    /// What became of the newest request: its value, the reason why there is none, or "stopped by the user".
    using Outcome = std::variant<std::shared_ptr<const void>, Error, Cancelled>;

    struct State {
        bool busy = false;      ///< a request is waiting or running
        bool stopping = false;  ///< cancel() was called, the job has not answered yet
        double fraction = 0;    ///< 0…1, never falling during a request
        Text stage;             ///< present stage of the running job, for people; empty: none given
    };

    Worker();
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Makes `job` the newest request. An answer of an older one is never delivered after this call.
    void request(Job job);

    /// Stops the newest request; its outcome is Cancelled, also where it has finished and was not taken.
    void cancel();

    State state() const;

    /// The outcome of the newest request, once.
    std::optional<Outcome> take();

private:
    void run(const std::stop_token& quit);
    void work(std::uint64_t number, const Job& job, const std::stop_token& stop);

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::uint64_t newest_ = 0;  ///< number of the newest request
    std::optional<Job> waiting_;
    std::stop_source stop_{std::nostopstate};  ///< of the running or waiting request
    State state_;
    std::optional<Outcome> outcome_;
    std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace lathelier
