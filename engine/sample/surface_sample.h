// Photographs of one surface before and after the speed was corrected: pictures made from physics, not photographs.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

/// surface_before.png: the whole width of a part of 30 mm, cut at 2016 rpm with marks of 361 Hz; surface_after.png: cut
/// at 2154 rpm without. The panel surface opens both, with the response of chatterSample().
const SamplePart& surfaceSample();

}  // namespace lathelier::sample
