#include "widgets/core/task/worker.h"

#include <algorithm>
#include <utility>

#include "engine/core/failure.h"

namespace lathelier {
namespace {

Worker::Outcome compute(const Worker::Job& job, const Progress& progress)
{
    try {
        return job(progress);
    } catch (const Cancelled& cancelled) {
        return cancelled;
    } catch (const std::exception& failure) {
        return toError(failure);
    }
}

}  // namespace

Worker::Worker() : thread_([this](const std::stop_token& quit) { run(quit); }) {}

Worker::~Worker()
{
    {
        const std::lock_guard lock(mutex_);
        waiting_.reset();
        stop_.request_stop();
    }
    thread_.request_stop();
    thread_.join();
}

void Worker::request(Job job)
{
    {
        const std::lock_guard lock(mutex_);
        stop_.request_stop();
        stop_ = std::stop_source();
        ++newest_;
        waiting_ = std::move(job);
        outcome_.reset();
        state_ = {true, false, 0, {}};
    }
    wake_.notify_one();
}

void Worker::cancel()
{
    const std::lock_guard lock(mutex_);
    if (!state_.busy) {
        if (outcome_) outcome_ = Cancelled();  // finished, but not taken yet
        return;
    }
    stop_.request_stop();
    state_.stopping = true;
    if (waiting_) {  // not started: answered immediately
        waiting_.reset();
        state_ = {};
        outcome_ = Cancelled();
    }
}

Worker::State Worker::state() const
{
    const std::lock_guard lock(mutex_);
    return state_;
}

std::optional<Worker::Outcome> Worker::take()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
}

void Worker::run(const std::stop_token& quit)
{
    while (true) {
        std::unique_lock lock(mutex_);
        if (!wake_.wait(lock, quit, [this] { return waiting_.has_value(); })) return;
        const Job job = std::move(*waiting_);
        waiting_.reset();
        const std::uint64_t number = newest_;
        const std::stop_token stop = stop_.get_token();
        lock.unlock();
        work(number, job, stop);
    }
}

void Worker::work(std::uint64_t number, const Job& job, const std::stop_token& stop)
{
    const Progress progress(stop, [this, number](double fraction, Text stage) {
        const std::lock_guard lock(mutex_);
        if (number != newest_) return;
        state_.fraction = std::max(state_.fraction, fraction);
        state_.stage = stage;
    });
    Outcome outcome = compute(job, progress);

    const std::lock_guard lock(mutex_);
    if (number != newest_) return;  // stale: a newer request is waiting
    // A job that finished in spite of cancel() still counts as stopped: the user requested no new result.
    outcome_ = stop.stop_requested() ? Outcome(Cancelled()) : std::move(outcome);
    state_ = {};
}

}  // namespace lathelier
