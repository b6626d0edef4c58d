// The task verify: does this installation reproduce reference data with known answers? A verdict against it is exit
// code 1 without --strict too.
#pragma once

#include "engine/task/task.h"

namespace lathelier::verify {

const task::Task& verifyTask();

}  // namespace lathelier::verify
