// Cache of frequency response files.
#pragma once

#include "engine/io/frf/frf_input.h"
#include "engine/task/inputs.h"

namespace lathelier::chatter_common {

using FrfStore = task::CacheOf<io::FrfInput>;

}  // namespace lathelier::chatter_common
