// The part of a shaft that stands out of the chuck: what a stock file describes.
#pragma once

#include "engine/core/shaft.h"

namespace lathelier::features {

/// The shaft without its last `chucked_mm`, the row there cut; bores laid into the rows (beamView).
Shaft outOfChuck(const Shaft& shaft, double chucked_mm);

}  // namespace lathelier::features
