// Roughing and finish as the cycles of a control (G71 and G70) instead of moves.
//
// The contour of both is the path of the finishing tool: first X alone, then a contour monotonic in X and Z (type I).
// The cycle leaves the allowance in X and in Z. The control computes the passes itself; the check uses the expansion of
// engine/gcode instead.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "engine/cam/operation.h"

namespace lathelier::cam {

/// Job data of a cycle.
struct CycleData {
    double depth_mm = 1;             ///< largest of a pass, on the radius
    double allowance_mm = 0;         ///< that it leaves, on the radius and along z
    double entering_angle_deg = 90;  ///< of the roughing tool
};

struct RoughingCycle {
    std::size_t rough = 0, semi_finish = 0, finish = 0;  ///< indices of the operations it replaces
    double start_z_mm = 0, start_x_mm = 0;               ///< of the tip, where it begins and ends
    double safe_x_mm = 0;                                ///< clearance radius from which the start is approached
    double depth_mm = 0;                                 ///< of equal passes
    double feed_mm_rev = 0;                              ///< of roughing
    std::vector<CutMove> before;                         ///< of the finish: up the face, back to the start
    std::vector<CutMove> contour;                        ///< the first along X alone
    bool has_finish = true;                              ///< false: the finish changes between both kinds of speed
};

/// The cycle for these operations, or the reason why it is impossible.
std::variant<RoughingCycle, Text> roughingCycle(const std::vector<Operation>& operations, const CycleData& data);

}  // namespace lathelier::cam
