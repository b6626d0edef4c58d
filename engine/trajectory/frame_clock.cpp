#include "engine/trajectory/frame_clock.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/units.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

/// Largest deviation from an even grid, in steps, that is attributed to the rounding of printed times.
constexpr double evenShare = 0.75;

}  // namespace

FrameClock::FrameClock(const io::ProbeRecord& record) : times_(record.time_s), frames_(record.frames())
{
    if (times_.size() != frames_ || frames_ < 2) {
        known_ = std::isfinite(record.rate_hz) && record.rate_hz > 0;
        step_s_ = known_ ? 1 / record.rate_hz : 1;
        return;
    }
    start_s_ = times_.front();
    step_s_ = (times_.back() - start_s_) / static_cast<double>(frames_ - 1);
    if (!(step_s_ > 0)) throw Error(errors::timeNotIncreasing, {{"row", std::int64_t{1}}});
    even_ = true;
    for (std::size_t i = 0; i < frames_ && even_; ++i)
        even_ = std::abs(times_[i] - (start_s_ + step_s_ * static_cast<double>(i))) <= evenShare * step_s_;
    if (even_) return;
    for (std::size_t i = 1; i < frames_; ++i)
        if (!(times_[i] > times_[i - 1]))
            throw Error(errors::timeNotIncreasing, {{"row", static_cast<std::int64_t>(i + 1)}});
}

double FrameClock::longestStep_s(double from_s, double to_s) const
{
    if (even_) return step_s_;
    double longest = 0;
    for (std::size_t i = frameBefore(from_s); i + 1 < frames_ && times_[i] < to_s; ++i)
        longest = std::max(longest, times_[i + 1] - times_[i]);
    return longest;
}

std::size_t FrameClock::frameBefore(double time_s) const
{
    if (even_) {
        const double place = std::floor((time_s - start_s_) / step_s_);
        return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(frames_ - 1)));
    }
    const auto after = std::upper_bound(times_.begin(), times_.end(), time_s);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - times_.begin() - 1));
}

double FrameClock::valueAt(std::span<const double> values, double time_s) const
{
    constexpr double slack = 1e-6;  // of a step: rounding at the ends
    if (frames_ < 4 || !(time_s >= this->time_s(0) - slack * step_s_) ||
        !(time_s <= this->time_s(frames_ - 1) + slack * step_s_))
        return notANumber;
    const std::size_t before = frameBefore(time_s);
    const std::size_t first = std::min(before > 0 ? before - 1 : 0, frames_ - 4);
    const double* const v = values.data() + first;
    if (even_) {
        const double x = (time_s - this->time_s(first)) / step_s_;  // frames at 0, 1, 2, 3
        const double a = x, b = x - 1, c = x - 2, d = x - 3;
        return -b * c * d / 6 * v[0] + a * c * d / 2 * v[1] - a * b * d / 2 * v[2] + a * b * c / 6 * v[3];
    }
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        double weight = 1;
        for (std::size_t j = 0; j < 4; ++j)
            if (j != i) weight *= (time_s - times_[first + j]) / (times_[first + i] - times_[first + j]);
        sum += weight * v[i];
    }
    return sum;
}

}  // namespace lathelier::trajectory
