#include "app/cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>

namespace lathelier::cli {
namespace {

constexpr std::int64_t pause_ms = 100;
constexpr std::int64_t firstEstimate_ms = 5000;  ///< before it, the beginning is not like the rest

std::int64_t clockTime()
{
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::string timeLeft(std::int64_t passed_ms, double fraction)
{
    constexpr double least = 1e-3;  // below, the rest is not known to a factor of two
    if (passed_ms < firstEstimate_ms || fraction < least || fraction >= 1) return {};
    const double left_s = static_cast<double>(passed_ms) / 1000 * (1 - fraction) / fraction;
    const auto seconds = static_cast<std::int64_t>(std::ceil(left_s));
    constexpr std::int64_t minute = 60, hour = 3600;
    if (seconds >= hour) return fmt::format("  {} h {:02} min left", seconds / hour, seconds % hour / minute);
    if (seconds >= minute) return fmt::format("  {} min {:02} s left", seconds / minute, seconds % minute);
    return fmt::format("  {} s left", seconds);
}

ProgressLine::ProgressLine(bool wanted) : enabled_(wanted && isatty(STDERR_FILENO)), begin_ms_(clockTime()) {}

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
    fmt::print(stderr, "\r\x1b[K{}{}{:.0f} %{}", stage.english, stage.empty() ? "" : "  ", 100 * fraction,
               timeLeft(now - begin_ms_, fraction));
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
