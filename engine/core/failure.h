// Failures that are not ours as errors of ours.
#pragma once

#include <exception>

#include "engine/core/error.h"

namespace lathelier {

/// An Error as it is; outOfMemory where memory or threads could not be had; `internal` with its words for all else.
Error toError(const std::exception& failure);

}  // namespace lathelier
