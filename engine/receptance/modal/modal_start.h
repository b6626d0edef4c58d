// A rational fraction through a receptance, for where its poles lie: a start for refineModes().
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

/// Poles of `count` pairs with a mass line and a constant beside them, by the iteration of Sanathanan and Koerner in
/// partial fractions with moved poles and a relaxed denominator: Gustavsen and Semlyen, IEEE Trans. Power Delivery 14
/// (1999) 1052 (vector fitting), Gustavsen, ibid. 21 (2006) 1587. Residues are left at 0. Throws Cancelled.
std::vector<PoleTerm> rationalStart(const FitLines& lines, int count, const Progress& progress = {});

/// One term more, where the weighted error of `model` stands out most.
std::vector<PoleTerm> withWorstPeak(const FitLines& lines, const Refined& model);

}  // namespace lathelier::receptance
