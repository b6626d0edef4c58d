// The pulses of a once-per-revolution marker.
#pragma once

#include <span>
#include <vector>

#include "engine/core/text.h"
#include "engine/trajectory/frame_clock.h"

namespace lathelier::trajectory {

/// The two levels of a marker, or the reason why the signal is not a marker.
struct MarkerLevels {
    double low = 0, high = 0;  ///< resting level and pulse level
    double threshold = 0;      ///< midpoint of the two levels
    bool high_is_rare = true;  ///< true: the pulses are positive
    Text complaint;            ///< reason why it is not a marker; empty for a marker

    bool isMarker() const { return complaint.empty(); }
};

/// A marker takes two levels and is rarely between them: less than a fifth of its values lie in the middle half of its
/// range (a sinusoid: a third; noise: most).
MarkerLevels findMarkerLevels(std::span<const double> values);

/// Times at which the signal crosses the threshold into its rarer level, on the clock of its own channel, interpolated
/// between frames. After a mark the signal has to come back over half of the way to its resting level.
std::vector<double> findMarks(std::span<const double> values, const FrameClock& clock, const MarkerLevels& levels);

}  // namespace lathelier::trajectory
