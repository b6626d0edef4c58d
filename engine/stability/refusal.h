// What a value of a parameter is refused with.
#pragma once

#include <utility>

#include "engine/core/core_codes.h"

namespace lathelier::stability {

/// Throws Error valueNotUnderstood: `found` was given where `expected` is asked for.
[[noreturn]] inline void refuse(const char* parameter, Value found, Text expected)
{
    throw Error(errors::valueNotUnderstood,
                {{"parameter", parameter}, {"found", std::move(found)}, {"expected", expected}});
}

}  // namespace lathelier::stability
