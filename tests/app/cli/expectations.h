// Does a run keep what its line promises?
#pragma once

#include <functional>
#include <string>

#include "tests/app/cli/golden_line.h"
#include "tests/app/cli/run_program.h"

namespace lathelier::golden {

/// What an expectation may look at.
struct Evidence {
    const Line& line;
    const Outcome& outcome;
    std::string out_folder;
    std::string data_folder;
    std::function<Outcome(const Run&)> again;
};

/// Empty when it holds, else what was found instead.
std::string check(const std::string& expectation, const Evidence& evidence);

}  // namespace lathelier::golden
