// The probe record of the sample project: one continuous recording of 20 sections, and the averages of each.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// probe_record.csv, opened by the panel roundness, and averaged.csv.
const SamplePart& recordSample();

}  // namespace lathelier::sample
