// The results of lobes and speed choice, described once.
#pragma once

#include "engine/core/json.h"
#include "engine/core/quantities.h"
#include "engine/stability/lobes.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::stability {

const std::vector<QuantityOf<SpeedCandidate>>& quantitiesOf(const SpeedCandidate*);
const std::vector<QuantityOf<SpeedResult>>& quantitiesOf(const SpeedResult*);
const std::vector<QuantityOf<LobeResult>>& quantitiesOf(const LobeResult*);

/// Depths under the key depth_mm, or relative_depth if they are multiples of the least limit; null if none.
Json toJson(const LobeResult& result);

}  // namespace lathelier::stability
