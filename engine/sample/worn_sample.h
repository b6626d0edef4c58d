// The scan of a worn shaft to be remanufactured.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// worn.ply: a stepped shaft with chamfers, a groove, a tapered seat and two worn bearing seats, opened by the panel
/// recognise; its table and its wear are in truth.json.
const SamplePart& wornSample();

}  // namespace lathelier::sample
