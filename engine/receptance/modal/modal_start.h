// Rational fraction fitted to a receptance: start poles for refineModes().
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

/// Poles of `count` pairs with a mass line and a constant beside them, by the iteration of Sanathanan and Koerner in
/// partial fractions with moved poles and a relaxed denominator: Gustavsen and Semlyen, IEEE Trans. Power Delivery 14
/// (1999) 1052 (vector fitting), Gustavsen, ibid. 21 (2006) 1587. Residues are 0. Throws Cancelled.
std::vector<PoleTerm> rationalStart(const FitLines& lines, int count, const Progress& progress = {});

/// One more term, at the largest weighted error of `model`.
std::vector<PoleTerm> withWorstPeak(const FitLines& lines, const Refined& model);

}  // namespace lathelier::receptance
