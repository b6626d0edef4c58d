// The noise of a measured frequency response, by line.
//
// Without coherence each line is compared with the cubic through its four neighbours: what differs is noise, but for
// the curvature at resonances that few lines resolve. The noise is additive and slowly varying in the quantity that was
// measured - an accelerometer's in the accelerance, whose receptance it magnifies by 1/ω² -, so that its logarithm is
// fitted over ln f by straight lines in sliding windows, without the few lines far above; a part proportional to the
// response is added as far as no stretch of lines contradicts it.
//
// With coherence σ² ∝ |G|² (1 - γ²)/γ² (Bendat and Piersol, "Random Data", 4th ed., section 9.2), averaged over nine
// lines; the number of averages is not stored, so that the factor is taken from the same differences. A coherence that
// is 1 at all lines is that of a single record and says nothing.
#pragma once

#include <vector>

#include "engine/core/frf.h"

namespace lathelier::io {

/// Standard deviation of the real and of the imaginary part of each line, in the unit of `frf.value`: pass the response
/// in the quantity that was measured. Empty for fewer than 9 lines. Cost: O(lines).
std::vector<double> noiseOf(const Frf& frf);

}  // namespace lathelier::io
