// Errors of tasks: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode oneNeeded{"one_needed", ErrorKind::WrongUsage,
                                     LT_TEXT("Engine", "Still needed: {names}.")};

inline constexpr ErrorCode oneOnly{"one_only", ErrorKind::WrongUsage,
                                   LT_TEXT("Engine", "Only one of these can be given: {names}.")};

}  // namespace lathelier::errors
