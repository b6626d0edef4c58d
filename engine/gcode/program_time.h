// Machining time of a program by tool.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/quantities.h"
#include "engine/gcode/move.h"

namespace lathelier::gcode {

/// Rapid traverse rates, which programs do not state.
struct RapidRates {
    double x_m_min = 20;  ///< of the slide, on radius
    double z_m_min = 20;
};

/// Times of one tool, or of all tools (number 0).
struct ToolTime {
    int tool = 0;                         ///< number; 0: the moves before the first tool call
    std::int64_t line = 0;                ///< line of its first move
    std::int64_t moves = 0;               ///< dwells included
    double feed_length_mm = 0;            ///< of feed moves, arcs and threads
    double rapid_length_mm = 0;           ///< between known positions
    double feed_time_s = 0;               ///< of the moves whose speed is known
    double rapid_time_s = 0;              ///< each axis at its own rate
    double dwell_time_s = 0;              ///< as programmed
    std::int64_t moves_without_time = 0;  ///< feed moves without feed or speed
    double time_s() const { return feed_time_s + rapid_time_s + dwell_time_s; }
};

struct ProgramTimes {
    ToolTime all;
    std::vector<ToolTime> tools;  ///< in order of first use
};

const std::vector<QuantityOf<ToolTime>>& quantitiesOf(const ToolTime*);
const std::vector<QuantityOf<ProgramTimes>>& quantitiesOf(const ProgramTimes*);

/// At constant surface speed v the spindle turns n = min(1000 v / (2 π x), limit); the time of a feed per revolution f
/// is ∫ ds / (f n), exact along straight lines; arcs become chords of 3°. Acceleration is neglected. O(moves).
ProgramTimes timesOf(std::span<const Move> moves, const RapidRates& rates = {});

}  // namespace lathelier::gcode
