// Cache of part files for the panels Drawing and Compare, with bores as stated.
#pragma once

#include "engine/cad/part_input.h"
#include "engine/task/inputs.h"

namespace lathelier::part_common {

using PartStore = task::CacheOf<cad::PartInput>;

}  // namespace lathelier::part_common
