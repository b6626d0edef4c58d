// A thread by its diameters, depth and number of passes (CYCLE97). Internal to the room.
//
// Source: SINUMERIK 840D/840Di/810D Programming Guide, Cycles (11.02), 4.9. The roughing passes share depth less
// allowance: evenly, or each with the same cross-section of the chip, pass k of n at the depth √(k/n) of theirs. Then
// one pass at full depth where there is an allowance, then the idle passes. Infeed at an angle displaces the passes
// along Z; where it starts is not stated: the last pass is where it is without an angle.
#pragma once

#include <cstdint>

#include "engine/gcode/cycles.h"

namespace lathelier::gcode {

/// Lengths in mm, on radius.
struct ThreadTurning {
    Point from;                  ///< on the surface, at the start of the thread
    Point to;                    ///< on the surface, at its end
    bool is_inner = false;       ///< the depth grows outward
    double run_in_mm = 0;        ///< before the start
    double run_out_mm = 0;       ///< behind the end
    double depth_mm = 0;         ///< of the thread
    double allowance_mm = 0;     ///< for the pass at full depth
    double angle_deg = 0;        ///< of the infeed; negative: alternating
    int roughs = 1;              ///< roughing passes
    int idles = 0;               ///< further passes at full depth
    int starts = 1;              ///< of the thread
    bool is_degressive = false;  ///< same cross-section of the chip
    double clearance_mm = 1;     ///< above the surface, on the way back
};

/// Begins and ends in front of the thread, above the surface.
CycleMoves threadTurning(const ThreadTurning& thread);
std::int64_t passesOfThread(const ThreadTurning& thread);

/// Pitch of the metric thread of this size, 3 (M3) to 60; ISO 261, coarse. 0: none.
double coarsePitch_mm(double size_mm);

}  // namespace lathelier::gcode
