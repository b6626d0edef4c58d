// Sampling times of the frames of a record, and interpolation of signals between frames.
#pragma once

#include <span>

#include "engine/io/probe/probe_record.h"

namespace lathelier::trajectory {

/// Times of the frames of a record. Rounded printed times are restored to their even grid. Without times and rate the
/// frame is the unit of time. Refers to the record: it must outlive the clock.
class FrameClock {
public:
    /// Error timeNotIncreasing (`row`, from 1) when the times of the record do not go forward.
    explicit FrameClock(const io::ProbeRecord& record);

    std::size_t frames() const { return frames_; }
    bool isKnown() const { return known_; }  ///< false: times are frame numbers
    double step_s() const { return step_s_; }
    double time_s(std::size_t frame) const
    {
        return even_ ? start_s_ + step_s_ * static_cast<double>(frame) : times_[frame];
    }

    /// Of the uneven times in [from_s, to_s]: the longest pause between frames; the step when the times are even.
    double longestStep_s(double from_s, double to_s) const;

    /// The last frame not after `time_s`, within the record.
    std::size_t frameBefore(double time_s) const;

    /// The signal at any time within the record (outside: NaN) by the cubic through the four frames around it: an error
    /// of (3/128) h⁴ f⁗, against h²/8 f″ of the straight line. NaN where one of the four has no value.
    double valueAt(std::span<const double> values, double time_s) const;

private:
    std::span<const double> times_;
    std::size_t frames_ = 0;
    double start_s_ = 0;
    double step_s_ = 1;
    bool even_ = true;
    bool known_ = true;
};

}  // namespace lathelier::trajectory
