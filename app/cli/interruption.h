// Ctrl-C as a request to stop.
#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace lathelier::cli {

/// Waits for SIGINT and SIGTERM in a thread of its own: the first asks the work to stop, the second ends the program
/// at once. Make it before any other thread, so that all of them leave these signals to it.
class Interruption {
public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    std::stop_token token() const { return source_.get_token(); }

private:
    void wait();

    std::stop_source source_;
    std::atomic<bool> done_{false};
    std::thread waiter_;
};

}  // namespace lathelier::cli
