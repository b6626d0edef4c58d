// Model order selection: fits with an increasing number of terms, and the choice among them.
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/core/value.h"
#include "engine/receptance/modal/modal_refine.h"
#include "engine/receptance/modal/modal_scan.h"

namespace lathelier::receptance {

struct OrderRequest {
    Interval range_hz;               ///< terms inside are modes, terms outside represent modes beyond
    int modes = 0;                   ///< within the range; 0: selected by the criterion
    bool complex_residues = false;   ///< residues with a phase
    std::vector<ResidueSign> signs;  ///< by response
    std::vector<Pole> stable;        ///< poles that stay over the orders of a linear fit, the surest first
};

/// Covariance of the parameters of one response, scaled by the variance of the errors found.
double scaleOf(const Refined& fit, std::span<const FitLines> lines, bool complex_residues);

/// Standard uncertainty of ln f (0) or ln ζ (1) of pole `k`.
double poleUncertainty(const Refined& fit, std::size_t k, int which, double scale);

/// Standard uncertainty of |a + ib| of pole `k` in a response.
double residueUncertainty(const Refined& fit, std::size_t response, std::size_t k, bool complex_residues, double scale);

/// Whether a term is at the bound of its frequency: it is then represented by the mass line or the compliance.
bool isAtEndOfReach(const Pole& pole, std::span<const FitLines> lines);

/// Only fits whose terms are all sound are candidates: determined by the data, seen at their own frequency, not
/// cancelling each other, of an allowed sign. Of these the one with the requested number of modes, or the largest
/// number below it; without a request the one with the least value of Schwarz's criterion, less the modes whose removal
/// increases χ² by less than noise may. Throws Cancelled.
Refined fitByOrder(std::span<const FitLines> lines, const OrderRequest& request, const Progress& progress = {});

}  // namespace lathelier::receptance
