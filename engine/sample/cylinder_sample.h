// The measured cylinder of the sample project: sections of a ground shaft with a known form.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// cylinder_sections.ply, opened by the panel cylindricity.
const SamplePart& cylinderSample();

}  // namespace lathelier::sample
