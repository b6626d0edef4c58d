// The part of a shaft outside the chuck, for a stock file.
#pragma once

#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// The shaft without its last `chucked_mm`, the row there cut; bores laid into the rows (beamView).
Shaft outOfChuck(const Shaft& shaft, double chucked_mm);

}  // namespace lathelier::features
