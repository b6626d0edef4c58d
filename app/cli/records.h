// Reading the profiles and probe records of a request.
#pragma once

#include "app/cli/verb.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/io/profile/profile_reader.h"

namespace lathelier::cli {

/// Reads one profile as the request's options say; what the reader notes goes into the answer.
io::ProfileFile readProfile(const std::string& path, const Request& request, io::InputFiles& inputs,
                            const Progress& progress, Answer& answer);

/// Reads one record, with the partner of an L-Graph file.
io::ProbeFile readRecord(const std::string& path, const Request& request, io::InputFiles& inputs,
                         const Progress& progress, Answer& answer);

}  // namespace lathelier::cli
