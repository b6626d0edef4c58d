// Errors of the walk through a part: codes with their English patterns.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode nothingFollows{
    "nothing_follows", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "“{place}” is answered, but nothing can be made from it before what it did not understand is settled.")};

}  // namespace lathelier::errors
