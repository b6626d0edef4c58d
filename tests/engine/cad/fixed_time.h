// Options of a STEP file that is the same whenever it is written.
#pragma once

#include "engine/cad/step_writer.h"

namespace lathelier::cad {

inline StepOptions fixedTime()
{
    StepOptions options;
    options.time_stamp = "2000-01-01T00:00:00";
    return options;
}

}  // namespace lathelier::cad
