// Statistics of signed deviations: exact quantiles, histogram.
#pragma once

#include <span>
#include <vector>

#include "engine/registration/compare.h"

namespace lathelier::registration {

/// Exact order statistics: the value at rank floor(share · n) for each share in 0…1. NaN for no values.
/// Finite values only. Time grows with the number of values, not with that of shares.
std::vector<double> quantiles(std::span<const float> values, const std::vector<double>& shares);

/// Fills points_used and all lengths of the statistics from the deviations of the used points.
DeviationStatistics summarise(std::span<const float> used_deviations_mm, const Progress& progress = {});

/// All values counted in bins of a round width (1, 2 or 5 times a power of ten), at most 500 of them.
Histogram histogramOf(std::span<const float> values, const Progress& progress = {});

}  // namespace lathelier::registration
