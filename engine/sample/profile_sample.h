// The measured profile of the sample project: one section of a seat with known undulations.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// profile.csv: angle in degrees and radius in mm.
const SamplePart& profileSample();

}  // namespace lathelier::sample
