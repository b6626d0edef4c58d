// The bores of a shaft, stated as a list or by the segments.
#pragma once

#include <vector>

#include "engine/shaft/shaft.h"

namespace lathelier {

/// Shaft::bores; else those that ShaftSegment::bore_diameter_mm states, a step for each row of the outside.
std::vector<ShaftBore> boresOf(const Shaft& shaft);

}  // namespace lathelier
