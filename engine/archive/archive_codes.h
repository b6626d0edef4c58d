// Errors and notes of the archive.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode evaluationAltered{
    "evaluation_altered", ErrorKind::InputRejected,
    LT_TEXT("Engine", "The evaluation says that its key is {found}; its content gives {expected}. It was altered.")};

}  // namespace lathelier::errors
