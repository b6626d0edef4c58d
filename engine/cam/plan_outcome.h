// Combined result of the checks of all programs of a plan: residual material and verdict.
#pragma once

#include "engine/cam/plan.h"
#include "engine/cam/plan_programs.h"

namespace lathelier::cam {

/// Check parameters of the program of a clamping; `count`: of all clampings.
CheckParameters checkParametersOf(const Clamping& clamping, std::size_t count, const TurningInputs& inputs);

/// The check of one program. Programs of the post are read in its dialect, others in the detected one. `before`: the
/// program of the first clamping; null: this is the first. Errors of checkTurning(). Throws Cancelled.
CheckResult checkProgram(const Shaft& part, const Job& job, const GivenProgram& program, const GivenProgram* before,
                         CheckParameters parameters, const Post& post, const Progress& progress);

/// First tool of the program that the job lacks, so that its cuts are not checked; 0: none.
int unknownToolOf(const CheckResult& check);

/// Fills in `rest`, `left_max_mm`, `is_refused`, `verdict` and `notes` from the checks of the plan's programs. Residual
/// material is that of the check of the last clamping; causes are taken from the plan where known. No verdict if a
/// program was not checked; undecided if a tool is missing in the job and nothing else fails.
void conclude(TurningPlan& plan);

}  // namespace lathelier::cam
