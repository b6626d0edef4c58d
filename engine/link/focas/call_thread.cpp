#include "engine/link/focas/call_thread.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

namespace lathelier::link {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

}  // namespace

struct CallThread::Job {
    Call call;
    bool has_begun = false;
    bool is_done = false;
};

struct CallThread::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::shared_ptr<Job>> waiting;
    bool shall_end = false;  ///< when nothing waits any more
    bool has_ended = false;
};

CallThread::CallThread(double timeout_ms)
    : timeout_ms_(timeout_ms), shared_(std::make_shared<Shared>()), thread_([shared = shared_] { work(shared); })
{
}

CallThread::~CallThread()
{
    bool has_ended = false;
    {
        std::unique_lock lock(shared_->mutex);
        shared_->shall_end = true;
        shared_->changed.notify_all();
        has_ended = shared_->changed.wait_for(lock, Milliseconds(timeout_ms_), [this] { return shared_->has_ended; });
    }
    if (has_ended)
        thread_.join();
    else
        thread_.detach();
}

bool CallThread::run(Call call)
{
    const auto job = std::make_shared<Job>();
    job->call = std::move(call);
    std::unique_lock lock(shared_->mutex);
    shared_->waiting.push_back(job);
    shared_->changed.notify_all();
    if (shared_->changed.wait_for(lock, Milliseconds(timeout_ms_), [&] { return job->is_done; })) return true;
    if (!job->has_begun) std::erase(shared_->waiting, job);
    return false;
}

void CallThread::post(Call call)
{
    const auto job = std::make_shared<Job>();
    job->call = std::move(call);
    const std::lock_guard lock(shared_->mutex);
    shared_->waiting.push_back(job);
    shared_->changed.notify_all();
}

void CallThread::work(const std::shared_ptr<Shared>& shared)
{
    std::unique_lock lock(shared->mutex);
    while (true) {
        shared->changed.wait(lock, [&] { return shared->shall_end || !shared->waiting.empty(); });
        if (shared->waiting.empty()) break;
        const std::shared_ptr<Job> job = shared->waiting.front();
        shared->waiting.pop_front();
        job->has_begun = true;
        lock.unlock();
        job->call();
        job->call = nullptr;  // what it owns ends here, before its caller goes on
        lock.lock();
        job->is_done = true;
        shared->changed.notify_all();
    }
    shared->has_ended = true;
    shared->changed.notify_all();
}

}  // namespace lathelier::link
