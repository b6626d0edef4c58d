// A program as straight tool strokes in workpiece coordinates.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/gcode/move.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::stock {

/// Tip path of one move.
struct ToolTravel {
    std::int64_t line = 0;  ///< of the block
    int tool = 0;
    bool is_rapid = false;        ///< false: feed, arc or thread
    bool is_thread = false;       ///< of feed moves
    bool has_start = false;       ///< false: start unknown
    bool is_in_reach = true;      ///< false: end unknown
    std::vector<Corner> corners;  ///< start (where known), chords of an arc, end
};

/// Tracks the tip position through a program.
class TipFollower {
public:
    explicit TipFollower(double z_zero_mm) : zZero_mm_(z_zero_mm) {}

    /// The next move; a dwell has no corners. Arcs become chords within `chord_mm`; coordinates that are no numbers, or
    /// larger than endless_mm, are not known.
    void take(const gcode::Move& move, double chord_mm, ToolTravel& travel);

private:
    double zZero_mm_ = 0;
    Corner at_;
    bool isKnown_ = false;
};

/// Number of connected sequences of feed moves of one tool, including those that cut nothing.
std::size_t countRuns(std::span<const gcode::Move> moves);

}  // namespace lathelier::stock
