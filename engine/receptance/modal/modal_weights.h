// Weights of the lines of a measured response in a modal fit.
#pragma once

#include "engine/core/frf.h"
#include "engine/core/value.h"
#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

/// The lines of `frf` in `range_hz` above 0 Hz, with weights 1/σ: σ is the noise of the line, from coherence where only
/// that is known, with a small share of |G| added for what no modal model gives; without both σ is proportional to |G|,
/// with a lower bound between resonances.
FitLines linesToFit(const Frf& frf, const Interval& range_hz);

/// Weights by σ² = a² + b²|G|², with a and b from the errors of the fit to a response, by reweighted least squares.
void reweigh(FitLines& lines, const Refined& fit, std::size_t response);

}  // namespace lathelier::receptance
