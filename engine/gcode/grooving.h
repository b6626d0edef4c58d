// A groove with straight walls across the axis, cut by a blade (CYCLE93). Internal to the room.
//
// Source: SINUMERIK 840D/840Di/810D Programming Guide, Cycles (11.02), 4.2. Cuts side by side, at most 95 % of the
// width of the blade less its corners apart, down to the allowances; then along walls and bottom, from both sides to
// the middle. The order of the cuts does not change what is left. Chamfers and roundings lie outside of the width.
#pragma once

#include <cstdint>

#include "engine/gcode/cycles.h"

namespace lathelier::gcode {

/// An edge between surface and wall.
struct GrooveEdge {
    double chamfer_mm = 0;   ///< leg at 45°; 0: none
    double rounding_mm = 0;  ///< radius; 0: none
};

/// Lengths in mm, on radius.
struct Grooving {
    double surface_mm = 0;           ///< radius of the surface
    double near_z_mm = 0;            ///< wall at the smaller Z
    double far_z_mm = 0;             ///< wall at the larger Z
    bool is_inner = false;           ///< into a bore
    bool is_from_far = false;        ///< the cuts begin at the wall of the larger Z
    double depth_mm = 0;             ///< of the groove
    GrooveEdge near_edge;            ///< at the wall of the smaller Z
    GrooveEdge far_edge;             ///< at that of the larger Z
    double allowance_bottom_mm = 0;  ///< for the finishing cut
    double allowance_wall_mm = 0;    ///< for the finishing cut
    double infeed_mm = 0;            ///< depth after which the blade retracts; 0: in one go
    double retreat_mm = 1;           ///< of that, and above the surface
    double dwell_s = 0;              ///< at the bottom
    double blade_mm = 0;             ///< width of the blade
    double corner_mm = 0;            ///< radius of its corners
    bool is_far_corner = false;      ///< the corner at the larger Z is programmed, not that at the smaller one
};

/// Number of cuts side by side; 0: the blade is too wide.
std::int64_t cutsOf(const Grooving& groove);
/// Ends above the surface, at the wall where the cuts begin. None where the blade is too wide or its corner does not
/// fit.
CycleMoves grooving(const Grooving& groove);

}  // namespace lathelier::gcode
