#include "app/cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace lathelier::cli {
namespace {

constexpr std::int64_t pause_ms = 100;

std::int64_t clockTime()
{
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ProgressLine::ProgressLine(bool wanted) : enabled_(wanted && isatty(STDERR_FILENO)) {}

ProgressLine::~ProgressLine()
{
    clear();
}

void ProgressLine::show(double fraction, Text stage)
{
    if (!enabled_) return;
    const std::int64_t now = clockTime();
    std::int64_t due = next_ms_.load();
    if (now < due || !next_ms_.compare_exchange_strong(due, now + pause_ms)) return;
    const std::lock_guard lock(mutex_);
    fmt::print(stderr, "\r\x1b[K{}{}{:.0f} %", stage.english, stage.empty() ? "" : "  ", 100 * fraction);
    std::fflush(stderr);
    visible_ = true;
}

void ProgressLine::clear()
{
    const std::lock_guard lock(mutex_);
    if (visible_) fmt::print(stderr, "\r\x1b[K");
    std::fflush(stderr);
    visible_ = false;
}

}  // namespace lathelier::cli
