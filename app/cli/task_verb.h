// The verb of a task: its inputs as operands and options, its question as options, its exports as outputs.
#pragma once

#include "app/cli/verb.h"

namespace lathelier::cli {

/// `task` outlives the verb.
Verb verbOf(const task::Task& task);

}  // namespace lathelier::cli
