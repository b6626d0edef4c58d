// The frequency lines of a response that was just read.
#pragma once

#include <cstdint>

#include "engine/core/frf.h"

namespace lathelier::io {

/// Leaves out the lines whose frequency or value is not finite; says how many.
std::int64_t dropUnusableLines(Frf& frf);

/// Error frfNotAscending (`found`, `previous`, `index` from 0), frfNone when there is no line.
void requireAscending(const Frf& frf);

}  // namespace lathelier::io
