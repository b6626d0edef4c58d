// How many modes a response supports: fits with more and more terms, and which of them is taken.
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/core/value.h"
#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

struct OrderRequest {
    Interval range_hz;              ///< terms inside are modes, terms outside stand for what lies beyond
    int modes = 0;                  ///< within the range; 0: as many as the data tell
    bool complex_residues = false;  ///< four parameters for each term
};

/// Standard uncertainties (relative for ln f, ln ζ; else in the unit of the parameter) of term `k`, parameter `j`.
double uncertaintyOf(const Refined& fit, const FitLines& lines, std::size_t k, int j, bool complex_residues);

/// At the end of its reach a term would go further: the mass line and the compliance stand for it.
bool isAtEndOfReach(const PoleTerm& term, const FitLines& lines);

/// Is the term determined by the data, seen at its own frequency, and not one of two that cancel each other?
bool isSound(const Refined& fit, const FitLines& lines, std::size_t k, bool complex_residues);

/// Only fits whose terms all are sound count. Of these the one with so many modes as asked, or with the most below;
/// where the number is left open, the one with the least criterion of Schwarz. Throws Cancelled.
Refined fitByOrder(const FitLines& lines, const OrderRequest& request, const Progress& progress = {});

}  // namespace lathelier::receptance
