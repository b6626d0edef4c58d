// The task turn: a part and a job to a turning program, checked as written. The verb and the panel Turning program.
//
// Precedence: a part that is given rules over the one within the job; where no job is given, the part's file is a job
// that holds its shaft. A window's form rules over the file that it was changed from. A program of a file, a corrected
// one, or one changed by hand stands in place of the planned one and is checked like it.
#pragma once

#include <memory>
#include <vector>

#include "engine/cam/plan.h"
#include "engine/cam/task/turn_programs.h"
#include "engine/cam/task/turn_question.h"
#include "engine/task/task.h"

namespace lathelier::cam {

struct TurnOutcome : task::Answered {
    TurningQuestion question;            ///< the parameters as a value
    bool is_changed = false;             ///< the form has precedence over the file
    bool has_own_post = false;           ///< of a file, not built in
    std::shared_ptr<TurningPlan> plan;   ///< with the programs as they stand here; never null
    std::vector<ShownProgram> programs;  ///< one for each set-up of the plan

    bool isVoid() const;  ///< a program was changed after its check
};

/// `keeps_outlines`: CheckParameters::keeps_outlines, for a window. Errors: those of the readers and of planTurning();
/// jobWithoutShaft. A refused plan is an outcome. Throws Cancelled.
TurnOutcome answerTurn(const project::PanelState& state, bool keeps_outlines, Stores& stores, task::Sources& sources,
                       const Progress& progress);

/// The answer of the plan, and what changes by hand and corrections do to it; the largest findings.
report::Answer answer(const TurnOutcome& outcome, const Language& language = {});

/// For callers that work with every task. Of a refused plan the error programRefused.
task::Outcome outcomeOf(const std::shared_ptr<const TurnOutcome>& outcome);

/// Errors of programs that must not be written: checkVoid, cutsNotChecked, programRefused.
void requireWritable(const TurnOutcome& outcome);

inline constexpr const char* programExport = "out";
inline constexpr const char* sheetExport = "setup-sheet";

const task::Task& turnTask();

}  // namespace lathelier::cam
