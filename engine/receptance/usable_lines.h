// The lines of a measured response that say something about the structure. A hammer test's lowest lines, and those
// above the hammer's range, hold the noise of the sensor; divided by ω² it outweighs every resonance, and a limit
// would be that of the noise.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/frf.h"
#include "engine/core/value.h"

namespace lathelier::receptance {

/// What of a response is used.
struct UsedLines {
    Interval range_hz;          ///< first and last line used
    std::int64_t left_out = 0;  ///< lines outside
    bool is_all_noise = false;  ///< nothing stands out of the noise: all lines are kept
};

/// From the first to the last of five consecutive lines whose values exceed four times their noise. Without noise all
/// lines.
UsedLines linesAboveNoise(const Frf& frf);

/// The lines within `range_hz`, and what they are. Error rangeWithoutLines for fewer than four.
UsedLines keepLines(Frf& frf, const Interval& range_hz);

/// Of the lines of a measured response those asked for, else those above the noise; notes linesOfNoiseLeftOut,
/// nothingAboveNoise with `path`. Errors as keepLines(); valueNotUnderstood for more than one range.
UsedLines takeUsableLines(Frf& frf, const std::vector<Interval>& asked_hz, const std::string& path, Notes& notes);

}  // namespace lathelier::receptance
