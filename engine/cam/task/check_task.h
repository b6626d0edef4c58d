// The task check: any turning program against its drawing, its stock and the surrounding bodies.
#pragma once

#include <memory>

#include "engine/cam/check/turning_check.h"
#include "engine/task/task.h"

namespace lathelier::cam {

struct CheckOutcome : task::Answered {
    Shaft part;                                 ///< as drawn
    std::shared_ptr<const CheckResult> result;  ///< never null
};

/// Errors: those of the readers and of checkTurning(); jobWithoutShaft. An error of the program is part of the result.
/// Throws Cancelled.
CheckOutcome answerCheck(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress);

/// For callers that work with every task; errors: the first one of the program.
task::Outcome outcomeOf(const std::shared_ptr<const CheckOutcome>& outcome);

const task::Task& checkTask();

}  // namespace lathelier::cam
