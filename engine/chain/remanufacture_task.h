// The task remanufacture: from the scan of a worn part to its drawing, its program and the proof of its copy, in one
// folder. The verb; the window runs the same chain step by step.
#pragma once

#include "engine/task/task.h"

namespace lathelier::chain {

const task::Task& remanufactureTask();

}  // namespace lathelier::chain
