// Tool motion of a program as plain values: moves in workpiece coordinates, and their connected runs. z from the free
// end toward the chuck, x a radius.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lathelier::deflection {

/// Centre of an arc; sense of rotation in the (z, x) plane, z to the right and x up.
struct ArcCentre {
    double z_mm = 0;
    double x_mm = 0;
    bool clockwise = false;  ///< in the (z, x) plane
    bool by_centre = false;  ///< its block states the centre; false: the radius
    friend bool operator==(const ArcCentre&, const ArcCentre&) = default;
};

/// A move, given by its end point. The first one is the start position.
struct ToolMove {
    double z_mm = 0;
    double x_mm = 0;               ///< end, radius
    bool is_feed = false;          ///< false: rapid or otherwise not cutting
    double feed_mm_rev = 0;        ///< of a feed move
    std::int64_t line = 0;         ///< of the block that caused it
    std::optional<ArcCentre> arc;  ///< none: straight
    friend bool operator==(const ToolMove&, const ToolMove&) = default;
};

/// A corner of a path. The stretch before it has this feed and comes from this line.
struct PathPoint {
    double z_mm = 0;         ///< of the tool's deepest point
    double x_mm = 0;         ///< radius
    double feed_mm_rev = 0;  ///< of the stretch that ends here
    std::int64_t line = 0;   ///< of the block that causes that stretch; of the first point, of the move that leads here
    bool is_block_end = true;        ///< false: within an arc
    std::optional<ArcCentre> arc{};  ///< of that stretch; none: straight
    friend bool operator==(const PathPoint&, const PathPoint&) = default;
};

/// A connected sequence of feed moves in one direction along z. Equal z of neighbours: a shoulder.
struct ToolRun {
    enum class Kind {
        TowardChuck,    ///< z non-decreasing, not constant
        TowardFreeEnd,  ///< z non-increasing, not constant
        Plunge          ///< at constant z, toward the axis
    };
    Kind kind = Kind::TowardChuck;
    std::vector<PathPoint> points;  ///< two at least
    friend bool operator==(const ToolRun&, const ToolRun&) = default;
};

inline constexpr double chordOfArc_mm = 1e-5;  ///< most that the chords of an arc leave it by

/// Points along the arc of `end`, from behind `from` up to `end`, whose chords leave it by `chord_mm` at most.
void appendArc(const PathPoint& from, const PathPoint& end, double chord_mm, std::vector<PathPoint>& points);

/// Arcs become chords that leave them by `chord_mm` at most. Moves along x alone at the start or end of a run are
/// excluded, as are rapid moves and retracting feed moves.
std::vector<ToolRun> toolRuns(std::span<const ToolMove> moves, double chord_mm = chordOfArc_mm);

}  // namespace lathelier::deflection
