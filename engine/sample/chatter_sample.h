// The machine and the shaft of the sample project: a half-finished shaft on a spindle known by tap tests.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// shaft.json, spindle.json, tip_response.uff, tap_tests.json, tap_tests.uff; the panels lobes and frf open the
/// response, shaft, speed and pass the shaft on its spindle, drawing the shaft, spindle the tap tests.
const SamplePart& chatterSample();

}  // namespace lathelier::sample
