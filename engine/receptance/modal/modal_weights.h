// Weights of the lines of a measured response in a modal fit.
#pragma once

#include "engine/core/frf.h"
#include "engine/core/value.h"
#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

/// The lines of `frf` in `range_hz` above 0 Hz, with initial weights. With coherence σ² = |G|² (1-γ²)/γ², averaged over
/// nine lines (Bendat and Piersol, "Random Data", 4th ed., section 9.2); else σ proportional to |G|, with a lower bound
/// between resonances.
FitLines linesToFit(const Frf& frf, const Interval& range_hz);

/// Weights by σ² = a² + b²|G|², with a and b from the errors of `model`, by reweighted least squares.
void reweigh(FitLines& lines, const Refined& model);

/// Decimation to about `most` lines: every n-th one, and all near the highest resonances.
FitLines thinned(const FitLines& lines, std::size_t most);

}  // namespace lathelier::receptance
