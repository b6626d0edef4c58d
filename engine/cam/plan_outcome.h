// What the checks of all programs of a plan say together: what stays on the part, and the verdict.
#pragma once

#include "engine/cam/plan.h"
#include "engine/cam/plan_programs.h"

namespace lathelier::cam {

/// How the program of a clamping is checked; `count`: of all clampings.
CheckParameters checkParametersOf(const Clamping& clamping, std::size_t count, const TurningInputs& inputs);

/// The check of one program. What the post wrote is read in the post's dialect, other texts in the one they look like.
/// `before`: the program of the first clamping; null: this is the first. Errors of checkTurning(). Throws Cancelled.
CheckResult checkProgram(const Shaft& part, const Job& job, const GivenProgram& program, const GivenProgram* before,
                         CheckParameters parameters, const Post& post, const Progress& progress);

/// Tools of the program that the job has not, whose cuts no check sees; 0: none.
int unknownToolOf(const CheckResult& check);

/// Fills in `rest`, `left_max_mm`, `is_refused`, `verdict` and `notes` from the checks of the plan's programs. What
/// stays has been seen by the last clamping's check; a cause is taken from the plan where that knows it. Without a
/// verdict where a program was not checked; undecided where a tool is not in the job and nothing else fails.
void conclude(TurningPlan& plan);

}  // namespace lathelier::cam
