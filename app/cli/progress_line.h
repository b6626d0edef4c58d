// Progress for people: one line on the terminal that rewrites itself.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

#include "engine/core/text.h"

namespace lathelier::cli {

/// "  2 min 05 s left" after `passed_ms` for this share of the whole; empty in the first five seconds, and while the
/// share is too small to tell.
std::string timeLeft(std::int64_t passed_ms, double fraction);

/// Shows the phase, the percentage and the time left on standard error when that is a terminal, at most ten times a
/// second. Thread-safe. Cleared by the destructor.
class ProgressLine {
public:
    explicit ProgressLine(bool wanted);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(double fraction, Text stage);
    void clear();

private:
    bool enabled_;
    bool visible_ = false;
    std::int64_t begin_ms_;
    std::atomic<std::int64_t> next_ms_{0};
    std::mutex mutex_;
};

}  // namespace lathelier::cli
