// Conversion of exceptions to Error.
#pragma once

#include <exception>

#include "engine/core/error.h"

namespace lathelier {

/// An Error unchanged; outOfMemory for a failed allocation or thread start; `internal` with its what() for everything
/// else.
Error toError(const std::exception& failure);

}  // namespace lathelier
