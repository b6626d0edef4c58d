// Model order selection: fits with an increasing number of terms, and the choice among them.
#pragma once

#include <optional>

#include "engine/core/progress.h"
#include "engine/core/value.h"
#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

struct OrderRequest {
    Interval range_hz;              ///< terms inside are modes, terms outside represent modes beyond
    int modes = 0;                  ///< within the range; 0: selected by the criterion
    bool complex_residues = false;  ///< complex residues: four parameters per term
};

/// Standard uncertainties (relative for ln f, ln ζ; else in the unit of the parameter) of term `k`, parameter `j`.
double uncertaintyOf(const Refined& fit, const FitLines& lines, std::size_t k, int j, bool complex_residues);

/// Whether a term is at the bound of its frequency: it is then represented by the mass line or the compliance.
bool isAtEndOfReach(const PoleTerm& term, const FitLines& lines);

/// Whether the term is determined by the data, contributes at its own frequency, and is not cancelled by another.
bool isSound(const Refined& fit, const FitLines& lines, std::size_t k, bool complex_residues);

/// Only fits whose terms are all sound are candidates. Of these the one with the requested number of modes, or the
/// largest number below it; without a request the one with the least value of Schwarz's criterion. Throws Cancelled.
Refined fitByOrder(const FitLines& lines, const OrderRequest& request, const Progress& progress = {});

}  // namespace lathelier::receptance
