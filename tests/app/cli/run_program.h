// Running the command line as a user or a script does.
#pragma once

#include "tests/app/cli/golden_line.h"

namespace lathelier::golden {

struct Outcome {
    int exit_code = -1;  ///< 128 + signal when killed by one; -1 when it did not end in two minutes (sanitized: 20)
    std::string standard_output;
    std::string standard_error;
};

Outcome runProgram(const std::string& program, const Run& run);

}  // namespace lathelier::golden
