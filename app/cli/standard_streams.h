// Standard output and standard error, with failures told.
#pragma once

#include <string_view>

namespace lathelier::cli {

enum class Stream {
    Answers,  ///< standard output
    Errors    ///< standard error; what cannot be written there is lost
};

/// Writes all of it. Error fileNotWritable for Answers, such as on a full disk or when the reader has gone.
void print(Stream stream, std::string_view text);

}  // namespace lathelier::cli
