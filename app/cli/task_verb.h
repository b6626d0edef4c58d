// The verb of a task: its inputs as operands and options, its question as options, its exports as outputs.
#pragma once

#include "app/cli/verb.h"

namespace lathelier::cli {

/// `task` outlives the verb.
Verb verbOf(const task::Task& task);

/// The inputs and parameters of a request as the state of a panel. Error valueNotUnderstood where a required input is
/// not given.
project::PanelState stateOf(const task::Task& task, const Request& request);

}  // namespace lathelier::cli
