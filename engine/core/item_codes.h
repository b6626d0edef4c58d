// Errors about items of a project: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode linesTooMany{
    "lines_too_many", ErrorKind::NoAnswer,
    LT_TEXT("Engine", "{lines} lines are too many to be kept in a project; at most {maximum} are.")};

}  // namespace lathelier::errors
