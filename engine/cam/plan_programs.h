// Replacement of programs written by a plan: edited by hand, or corrected for deflection. They are checked like planned
// ones, against the drawing or the drawing with the stated correction.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/plan.h"

namespace lathelier::cam {

/// A program for one clamping of a plan.
struct GivenProgram {
    std::size_t setup = 0;  ///< index of the clamping
    std::string text;
    gcode::StatedCorrection correction;  ///< intended offset from the drawing; z of its clamping
    bool is_checked = true;              ///< false: parsed only
    bool is_of_post = true;              ///< in the dialect of the post; false: dialect is detected
};

/// The plan with these programs. All programs from the first replaced one on are checked again, as later clampings
/// depend on the stock of earlier ones; `rest`, `left_max_mm`, `is_refused`, `verdict` and `notes` follow. Operations
/// keep their planned data; their first line is updated (0: not found). A program with errors, or one that is not
/// checked, leaves the plan without a verdict, as it does programs after it. `inputs`: those of planTurning(). Errors:
/// those of checkTurning(). Precondition: `setup` is in range. Throws Cancelled.
TurningPlan withPrograms(TurningPlan plan, const std::vector<GivenProgram>& given, const TurningInputs& inputs,
                         const Progress& progress = {});

}  // namespace lathelier::cam
