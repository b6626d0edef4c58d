// Errors about marks of a shaft: codes with their English patterns. {name} is replaced by the named value.
#pragma once

#include "engine/core/error.h"

namespace lathelier::errors {

inline constexpr ErrorCode markNotTurned{
    "mark_not_turned", ErrorKind::NoAnswer,
    LT_TEXT("Engine",
            "The shaft has a mark that is not turned: {mark}, z {z_start_mm:1} to {z_end_mm:1} mm. No solid and no "
            "program are made of its rows alone; the drawing shows it.")};

}  // namespace lathelier::errors
