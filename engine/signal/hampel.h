// Outliers by a moving median: Hampel's identifier (Hampel 1974; Davies and Gather, JASA 88 (1993) 782-792).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::signal {

struct HampelOptions {
    int half_window = 5;      ///< neighbours on each side; 0: one median of all values
    double threshold = 5;     ///< in robust standard deviations; the usual 3 would reject regular peaks of long records
    bool closed = true;       ///< the sequence is periodic
    double least_spread = 0;  ///< lower bound of the standard deviation, such as the resolution of the values
};

/// 1 where a value lies further from the median of its window than `threshold` robust standard deviations (1.4826 ×
/// median of the absolute deviations; the larger of the window's and of the whole record's). Values that are not finite
/// are outliers and excluded from the statistics.
std::vector<std::uint8_t> hampelOutliers(std::span<const double> values, const HampelOptions& options = {},
                                         const Progress& progress = {});

/// 1.4826 × the median of absolute deviations from the median: the standard deviation of normal values.
double robustSpread(const std::vector<double>& values);
/// The same of absolute deviations from `centre`.
double robustSpread(const std::vector<double>& values, double centre);

}  // namespace lathelier::signal
