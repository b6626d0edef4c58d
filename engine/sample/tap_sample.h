// A tap test of the sample project: hammer and accelerometer over time, with modes that are known.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// tap_record.csv: five hits, one of them double; the panel Tap test opens it.
const SamplePart& tapSample();

}  // namespace lathelier::sample
