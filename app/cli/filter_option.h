// --no-filter: explicit form of the default of the verbs that filter.
#pragma once

#include "app/cli/verb.h"
#include "engine/form/roundness/roundness.h"

namespace lathelier::cli {

/// A flag of a verb that no parameter struct holds.
Option flagOption(const char* key, Text label, Text help);

Option noFilterOption();

/// Error valueNotUnderstood when --no-filter stands beside a filter.
void checkNoFilter(const Request& request, const form::RoundnessParameters& parameters);

}  // namespace lathelier::cli
