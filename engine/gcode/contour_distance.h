// A contour at equal distance from a given one, for cycles that leave stock normal to the contour. Internal to the
// room.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/gcode/arc.h"

namespace lathelier::gcode {

/// The contour, or why there is none.
struct ContourAtDistance {
    enum class State : std::uint8_t {
        Made,
        Parallel,  ///< two straight pieces in a row have the same direction
        Unsure     ///< a piece vanishes, an arc has a corner without an arc about it, or rounding decides
    };
    std::vector<Piece> pieces;
    State state = State::Made;
};

/// Every piece shifted by `left` (in the unit of the pieces; negative: right) along its normals. Outer corners are
/// joined by an arc about the corner, inner and very small ones at the intersection; a tangential transition stays one.
/// `is_face`: its feed is along X.
ContourAtDistance contourAtDistance(const std::vector<Piece>& contour, double left, bool is_face);

/// Angle that an arc sweeps, in radians, from 0 to 2π; 0 for a straight piece.
double sweepOf(const Piece& piece);

}  // namespace lathelier::gcode
