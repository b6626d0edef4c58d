// Calls of a foreign library in a thread of their own, one after the other: the caller goes on without one that is
// late.
//
// A call that has begun cannot be interrupted. It goes on, and those after it wait: what is late is never done after
// something newer. One that had not begun when its time ran out is taken back.
#pragma once

#include <functional>
#include <memory>
#include <thread>

namespace lathelier::link {

class CallThread {
public:
    using Call = std::function<void()>;  ///< owns what it uses; throws nothing

    explicit CallThread(double timeout_ms);
    /// Waits for the calls that are left, at most for the time-out; then the thread is left to end by itself.
    ~CallThread();
    CallThread(const CallThread&) = delete;
    CallThread& operator=(const CallThread&) = delete;

    /// Whether it was done within the time-out.
    bool run(Call call);

    /// Does it after the others, without waiting for it; it is never taken back.
    void post(Call call);

private:
    struct Job;
    struct Shared;
    static void work(const std::shared_ptr<Shared>& shared);

    double timeout_ms_;
    std::shared_ptr<Shared> shared_;
    std::thread thread_;
};

}  // namespace lathelier::link
