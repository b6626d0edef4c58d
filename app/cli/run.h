// One invocation from its request to its exit code.
#pragma once

#include <stop_token>

#include "app/cli/arguments.h"

namespace lathelier::cli {

// The exit codes that scripts rely on; those of errors: task::exitCode().
inline constexpr int exitAnswered = 0;
inline constexpr int exitOutOfTolerance = 1;
inline constexpr int exitCancelled = 130;

int run(const Invocation& invocation, std::stop_token stop);

}  // namespace lathelier::cli
