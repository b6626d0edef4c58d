// Reading the scans of a request.
#pragma once

#include "app/cli/verb.h"
#include "engine/io/cloud/scan_reader.h"

namespace lathelier::cli {

/// Reads one scan as the request's options say; what the reader notes goes into the answer.
io::ScanFile readScan(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                      Answer& answer);

/// The same of a file that `inputs` has open, as `bytes`, which are no longer valid afterwards.
io::ScanFile readScan(const std::string& path, std::string_view bytes, const Request& request, io::InputFiles& inputs,
                      const Progress& progress, Answer& answer);

}  // namespace lathelier::cli
