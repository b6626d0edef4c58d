// Caches of shaft and spindle files.
#pragma once

#include "engine/io/shaft/shaft_input.h"
#include "engine/receptance/spindle_input.h"
#include "engine/task/inputs.h"

namespace lathelier::chatter_common {

using ShaftStore = task::CacheOf<io::ShaftInput>;
using SpindleStore = task::CacheOf<receptance::SpindleInput>;

}  // namespace lathelier::chatter_common
