// How long a program moves and cuts, by tool: what a person asks first of a program.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/quantities.h"
#include "engine/gcode/move.h"

namespace lathelier::gcode {

/// Rates of the slides at rapid moves; programs do not state them.
struct RapidRates {
    double x_m_min = 20;  ///< of the slide, on radius
    double z_m_min = 20;
};

/// One tool, or all of them (number 0).
struct ToolTime {
    int tool = 0;                         ///< number; 0: the moves before the first tool call
    std::int64_t line = 0;                ///< of its first move
    std::int64_t moves = 0;               ///< dwells included
    double feed_length_mm = 0;            ///< of feed moves, arcs and threads
    double rapid_length_mm = 0;           ///< between places that are known
    double feed_time_s = 0;               ///< of the moves whose speed is known
    double rapid_time_s = 0;              ///< each axis at its own rate
    double dwell_time_s = 0;              ///< as programmed
    std::int64_t moves_without_time = 0;  ///< feed moves that state no feed or no speed
    double time_s() const { return feed_time_s + rapid_time_s + dwell_time_s; }
};

struct ProgramTimes {
    ToolTime all;                 ///< their sum
    std::vector<ToolTime> tools;  ///< by first use
};

const std::vector<QuantityOf<ToolTime>>& quantitiesOf(const ToolTime*);
const std::vector<QuantityOf<ProgramTimes>>& quantitiesOf(const ProgramTimes*);

/// At constant surface speed v the spindle turns n = min(1000 v / (2 π x), limit); the time of a feed per revolution f
/// is ∫ ds / (f n), exact along straight lines; arcs become chords of 3°. Slides and spindle follow at once: no
/// acceleration. O(moves).
ProgramTimes timesOf(std::span<const Move> moves, const RapidRates& rates = {});

}  // namespace lathelier::gcode
