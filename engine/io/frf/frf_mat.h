// Frequency responses in MAT files.
#pragma once

#include <string_view>

#include "engine/io/frf/frf_reader.h"
#include "engine/io/frf/mat_file.h"

namespace lathelier::io {

/// A file from memory. Errors as readFrf().
FrfFile readFrfMat(const std::string& name, std::string_view bytes, const FrfOptions& options,
                   const Progress& progress);

/// Format "MAT" and the list of variables.
FileFacts matFacts(const std::string& name, const std::vector<MatVariable>& variables);

}  // namespace lathelier::io
