// A program as straight strokes of the tool in the coordinates of the work.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/gcode/move.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::stock {

/// What one move does to the tip.
struct ToolTravel {
    std::int64_t line = 0;        ///< of the block
    int tool = 0;                 ///< number
    bool is_rapid = false;        ///< else feed, arc or thread
    bool is_thread = false;       ///< of feed moves
    bool has_start = false;       ///< false: comes from nowhere
    bool is_in_reach = true;      ///< false: leads to a place that is not known
    std::vector<Corner> corners;  ///< start (where known), chords of an arc, end
};

/// Follows the position of the tip through a program.
class TipFollower {
public:
    explicit TipFollower(double z_zero_mm) : z_zero_mm_(z_zero_mm) {}

    /// The next move; a dwell has no corners. Arcs become chords within `chord_mm`; coordinates that are no numbers, or
    /// larger than endless_mm, are not known.
    void take(const gcode::Move& move, double chord_mm, ToolTravel& travel);

private:
    double z_zero_mm_ = 0;
    Corner at_;
    bool is_known_ = false;
};

/// How many unbroken runs of feed moves of one tool there are; those that cut nothing among them.
std::size_t countRuns(std::span<const gcode::Move> moves);

}  // namespace lathelier::stock
