// Reading what a turning program is made of and checked against: JOB.json and the part.
#pragma once

#include <string>

#include "app/cli/verb.h"
#include "engine/cam/job_file.h"

namespace lathelier::cli {

/// The job in the file at `path`; its notes go into the answer. Errors carry the path.
cam::Job readJob(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                 Answer& answer);

/// The part in the file at `path` (any_shaft.h); empty: the one within the job, which came from `job_path`. Error
/// jobWithoutShaft; others carry the path.
Shaft partOf(const cam::Job& job, const std::string& path, const std::string& job_path, io::InputFiles& inputs,
             const Progress& progress, Answer& answer);

}  // namespace lathelier::cli
