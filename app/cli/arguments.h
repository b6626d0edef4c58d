// From argv to a checked request.
#pragma once

#include <optional>
#include <string>

#include "app/cli/verb.h"

namespace lathelier::cli {

/// The options every verb has.
struct CommonOptions {
    std::string json;    ///< empty: none, "-": standard output
    std::string report;  ///< empty: none
    bool strict = false;
    bool quiet = false;
    int threads = 0;  ///< 0: all cores
};

struct Invocation {
    const Verb* verb = nullptr;
    Request request;
    CommonOptions common;
};

/// Either something to run, or an exit code because help, the version or a usage error has been printed.
struct Parsed {
    std::optional<Invocation> invocation;
    int exit_code = 0;
};

Parsed parseArguments(int argc, char** argv);

}  // namespace lathelier::cli
