// The revolutions of a record: from the pulses of a marker, or from an encoder's angle.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/trajectory/channel_map.h"
#include "engine/trajectory/frame_clock.h"

namespace lathelier::trajectory {

struct Revolution {
    std::int64_t number = 0;  ///< from 0; from 0; counts spindle revolutions, so that a lost mark skips a number
    double start_s = 0;       ///< angle 0 passes the probes, on the clock of channel 0
    double end_s = 0;         ///< next passage of angle 0, on the same clock
    bool regular = true;      ///< false: period off by more than 2 % of the median, or a pause in the recording
};

/// A period further than this from the median is not one revolution, unless it is within one frame.
inline constexpr double periodTolerance = 0.02;

/// A single revolution gives no estimate of scatter.
inline constexpr std::int64_t fewestRevolutions = 2;

struct Revolutions {
    std::vector<Revolution> all;  ///< in order of time
    int irregular = 0;            ///< number of irregular revolutions
    double period_s = 0;          ///< median period
    double threshold = 0;         ///< of the marker, in its unit
    std::vector<double> turns;    ///< encoder: turns since the first frame, for each frame, monotone
    bool falling = false;         ///< encoder: its angle decreases
    double angle_skew_s = 0;      ///< encoder: how much later its channel is sampled than its frame

    /// Time at which the recorded angle was `fraction` (0…1) of a turn within `revolution`. Between two marks the speed
    /// is taken as constant.
    double timeAt(const FrameClock& clock, const Revolution& revolution, double fraction) const;
};

/// Marks are the leading edges of the pulses: crossings of the threshold into the rarer of the marker's two levels,
/// interpolated between frames; the signal must return by half of the difference before the next edge is accepted.
/// Errors: markerNotFound (`channel`, `reason`) where the signal is not a pulse train, markerElsewhere (`candidate`)
/// when another channel is; angleNotTurning; tooFewRevolutions (`found`, `minimum` 2).
Revolutions findRevolutions(const io::ProbeRecord& record, const FrameClock& clock, const ChannelMap& map,
                            const TrajectoryParameters& parameters, double channel_skew_s);

}  // namespace lathelier::trajectory
