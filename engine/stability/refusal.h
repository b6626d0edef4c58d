// Error for an invalid parameter value.
#pragma once

#include <utility>

#include "engine/core/core_codes.h"

namespace lathelier::stability {

/// Throws Error valueNotUnderstood: `found` was given, `expected` describes valid values.
[[noreturn]] inline void refuse(const char* parameter, Value found, Text expected)
{
    throw Error(errors::valueNotUnderstood,
                {{"parameter", parameter}, {"found", std::move(found)}, {"expected", expected}});
}

}  // namespace lathelier::stability
