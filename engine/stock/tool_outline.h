// The tool in the meridian plane: outline of its insert and holder, as convex polygons about the imaginary tip that the
// program moves (compensation is in the moves already). Angles and numbers of the tip: core/tool.h.
//
// The corner is a circle of radius r that both edges touch; it is approximated by an inscribed polygon within
// noseChord_mm, with corners at its extreme points along z and x, so that a cylinder and a face are turned exactly.
// Boring bars and threading inserts are outlined as their insert.
#pragma once

#include <vector>

#include "engine/core/tool.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::stock {

inline constexpr double noseChord_mm = 0.002;

/// Tool outline with defaults applied, with the imaginary tip at (0, 0), in the coordinates of the work (z toward the
/// chuck).
struct ToolOutline {
    ConvexPolygon insert;
    std::vector<ConvexPolygon> holders;  ///< parts that must not touch the stock; may be empty
    bool is_assumed = false;             ///< a value needed by the shape was not stated
    double corner_radius_mm = 0;         ///< after applying defaults, as the following
    double entering_angle_deg = 0;       ///< 0: the kind has none
    double tip_angle_deg = 0;            ///< 0: the kind has none
    double reach_mm = 0;  ///< edge of an insert, depth of a blade, length of a drill; 0: the kind has none
};

/// Shank: 100 mm long, its lower end one edge length above the tip, its side toward the feed a quarter of its width
/// behind the tip (ISO 5610: f = 1.25 b). Errors toolImpossible (κ + ε at least 180°, or a corner larger than the
/// insert).
ToolOutline outlineOf(const Tool& tool);

}  // namespace lathelier::stock
