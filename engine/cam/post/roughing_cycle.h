// Roughing and finish as the cycles of a control (G71 and G70) instead of moves.
//
// The contour of both is the path of the finishing tool: first X alone, then a contour of which both X and Z only rise
// (type I). The cycle leaves the allowance in X and in Z. The control lays the passes by itself, so what it does is
// known only as far as our reader's expansion goes (engine/gcode); the check looks at that.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "engine/cam/operation.h"

namespace lathelier::cam {

/// What a cycle takes from the job.
struct CycleData {
    double depth_mm = 1;             ///< largest of a pass, on the radius
    double allowance_mm = 0;         ///< that it leaves, on the radius and along z
    double entering_angle_deg = 90;  ///< of the roughing tool
};

struct RoughingCycle {
    std::size_t rough = 0, semi_finish = 0, finish = 0;  ///< operations that it stands for
    double start_z_mm = 0, start_x_mm = 0;               ///< of the tip, where it begins and ends
    double safe_x_mm = 0;                                ///< from where it gets there
    double depth_mm = 0;                                 ///< of equal passes
    double feed_mm_rev = 0;                              ///< of roughing
    std::vector<CutMove> before;                         ///< of the finish: up the face, back to the start
    std::vector<CutMove> contour;                        ///< the first along X alone
    bool has_finish = true;                              ///< false: the finish changes between both kinds of speed
};

/// The cycle for these operations, or the reason why there is none.
std::variant<RoughingCycle, Text> roughingCycle(const std::vector<Operation>& operations, const CycleData& data);

}  // namespace lathelier::cam
