// The place in its file of what an error of a job or its part is about.
#pragma once

#include "engine/cam/job.h"
#include "engine/core/error.h"
#include "engine/project/project.h"

namespace lathelier::cam {

/// Adds path, line and column to the errors of job_rules.h and jobWithoutShaft: of the tool, the size of the bar, the
/// row of the part, the job. Errors of other codes, and inputs that are no files, stay as they are. `job`: as it was
/// read from the file.
void locateInJob(Error& error, const project::PanelState& state, const Job& job);

}  // namespace lathelier::cam
