// Checks of the frequency lines of a response.
#pragma once

#include <cstdint>

#include "engine/core/frf.h"

namespace lathelier::io {

/// Removes lines whose frequency or value is not finite; returns their number.
std::int64_t dropUnusableLines(Frf& frf);

/// Error frfNotAscending (`found`, `previous`, `index` from 0), frfNone when there is no line.
void requireAscending(const Frf& frf);

}  // namespace lathelier::io
