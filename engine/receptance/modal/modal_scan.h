// Search for a mode that a model does not have: matched filters over the errors of a fit.
#pragma once

#include <vector>

#include "engine/receptance/modal/modal_refine.h"

namespace lathelier::receptance {

/// What a response allows: only positive residues at a driving point.
enum class ResidueSign { Any, Positive };

struct Candidate {
    Pole pole;
    double gain = 0;  ///< decrease of χ² by a mode of this pole and the best real residues, all else kept
};

/// The pole with the largest gain: at every line, with half-power half-widths of 0.7 lines to a fifth of the lines,
/// each 1.6 times the last. The templates 1/(i - x), x = (f - f_n)/(ζ f_n), reach five half-widths to both sides. Gain
/// 0 where no mode of an allowed sign decreases χ². Throws Cancelled.
Candidate strongestMissing(std::span<const FitLines> lines, const Refined& fit, std::span<const ResidueSign> signs,
                           const Progress& progress = {});

/// Variance of the errors of a fit that no smooth curve explains, relative to σ², by line: from the median of the
/// differences from the cubic through four neighbours. Above 1 where σ is too small.
std::vector<double> scatterOf(const FitLines& lines, const Refined& fit, std::size_t response);

}  // namespace lathelier::receptance
