// What opened and dropped files are refused for, before they take a place.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode fileOfOtherKind{"file_of_other_kind", ErrorKind::InputRejected,
                                           LT_TEXT("Engine", "Not taken: found {found}, expected {expected}.")};

}  // namespace lathelier::errors
