// The scans of the sample project: the paper's shaft and a copy with known errors.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// original.ply and copy.ply, opened by the panel compare.
const SamplePart& scanSample();

}  // namespace lathelier::sample
