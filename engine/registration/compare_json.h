// A comparison as JSON, with the keys that scripts know.
#pragma once

#include "engine/core/json.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

/// All numbers of the result but the deviations of single points. `notes` and `parameters` are not included: the
/// command adds them for every verb alike. Numbers that do not exist are null.
Json toJson(const CompareResult& result);

}  // namespace lathelier::registration
