// Latest job wins: one background thread that computes the newest request and drops outdated ones. Without Qt, so that
// it can be tested under ThreadSanitizer.
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

/// Owns a thread. request() replaces a waiting job and stops a running one; the owner polls progress() and take() (a
/// panel does so every 5 ms at first, later 30 times a second). Every member may be called from any thread. The
/// destructor stops the running job and waits for it, which takes as long as the engine's progress interval (at most 20
/// ms).
class Worker {
public:
    /// Computes the answer; throws Error, Cancelled or whatever the standard library throws.
    using Job = std::function<std::shared_ptr<const void>(const Progress&)>;

    /// Outcome of the newest request: its value, the error, or cancellation by the user.
    using Outcome = std::variant<std::shared_ptr<const void>, Error, Cancelled>;

    struct State {
        bool busy = false;      ///< a request is waiting or running
        bool stopping = false;  ///< cancel() was called, the job has not ended yet
        double fraction = 0;    ///< 0…1, monotone during a request
        Text stage;             ///< displayed stage of the running job; empty: none
    };

    Worker();
    ~Worker();
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    /// Makes `job` the newest request. The outcome of an older one is not delivered after this call.
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
    std::stop_source stop_{std::nostopstate};  ///< stop source of the running or waiting request
    State state_;
    std::optional<Outcome> outcome_;
    std::jthread thread_;  ///< last member: it uses all of the above
};

}  // namespace lathelier
