// Photographs of one surface before and after the speed was corrected: synthetic pictures from a physical model.
#pragma once

#include "engine/core/sample_part.h"

namespace lathelier::sample {

inline constexpr double surfaceSample_mm_px = 0.015;  ///< scale of both

/// surface_before.png: the whole width of a part of 30 mm, feed 0.1 mm to the right, cut downward at 2016 rpm with
/// marks of the frequency at which the tip of chatterSample()'s shaft chatters there; surface_after.png: cut at 2154
/// rpm without. The panel surface opens both, with that response.
const SamplePart& surfaceSample();

}  // namespace lathelier::sample
