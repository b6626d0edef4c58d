// Standard output and standard error with error reporting.
#pragma once

#include <string_view>

#include "engine/core/progress.h"

namespace lathelier::cli {

enum class Stream {
    Answers,  ///< standard output
    Errors    ///< standard error; what cannot be written there is lost
};

/// Writes all of it, also where the stream does not block. Error fileNotWritable for Answers, such as on a full disk or
/// when the reader has gone. Throws Cancelled while a reader keeps it waiting.
void print(Stream stream, std::string_view text, const Progress& progress = {});

}  // namespace lathelier::cli
