// Progress for people: one line on the terminal that rewrites itself.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>

#include "engine/core/text.h"

namespace lathelier::cli {

/// Shows the phase and the percentage on standard error when that is a terminal, at most ten times a second.
/// Thread-safe. Cleared by the destructor.
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
    std::atomic<std::int64_t> next_ms_{0};
    std::mutex mutex_;
};

}  // namespace lathelier::cli
