// Programs in place of those that a plan wrote: changed by hand, or corrected for deflection. They are checked as the
// plan's own were, against the drawing or the drawing with the stated correction.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/plan.h"

namespace lathelier::cam {

/// A program for one clamping of a plan.
struct GivenProgram {
    std::size_t setup = 0;        ///< index of the clamping
    std::string text;             ///< of the program
    StatedCorrection correction;  ///< what it stands off from the drawing on purpose; z of its clamping
    bool is_checked = true;       ///< false: it is read alone, and nothing is said of it
    bool is_of_post = true;       ///< in the dialect of the plan's post; false: in the one that it looks like
};

/// The plan with these programs. Every program is checked again from the first given one on, as later clampings meet
/// what earlier ones leave; `rest`, `left_max_mm`, `is_refused`, `verdict` and `notes` follow. Operations keep what was
/// planned of them, with the line where their first block stands now (0: it is gone). A program with errors, or one
/// that is not checked, leaves the plan without a verdict, as it does programs after it. `inputs`: those of
/// planTurning(). Errors: those of checkTurning(). Precondition: `setup` is in range. Throws Cancelled.
TurningPlan withPrograms(TurningPlan plan, const std::vector<GivenProgram>& given, const TurningInputs& inputs,
                         const Progress& progress = {});

}  // namespace lathelier::cam
