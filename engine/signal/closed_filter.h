// Several filters of the same closed profile with a shared series.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "engine/signal/closed_profile.h"

namespace lathelier::signal {

/// filterClosedAt() for the same values and several bands. The trigonometric polynomial that fits the values is
/// computed once, with the orders required by the largest cut-off.
class ClosedFilter {
public:
    /// `values` in the order of the sampling, which must outlive this object.
    ClosedFilter(const AngularSampling& sampling, std::vector<double> values, double largest_cutoff_upr);

    /// The filtered values in the order of the sampling. Throws Cancelled.
    FilteredValues operator()(const TransmissionBand& band, const Progress& progress = {});

    /// The filtered values at `count` even angles from 0; none when the series is not applicable or contains waves too
    /// short for this spacing.
    std::optional<std::vector<double>> even(const TransmissionBand& band, std::size_t count,
                                            const Progress& progress = {});

private:
    bool bySeries(const TransmissionBand& band, const Progress& progress, std::vector<double>& result);
    std::vector<std::complex<double>> passed(const TransmissionBand& band, const Progress& progress);

    const AngularSampling& sampling_;
    std::vector<double> values_;  ///< minus their mean where angles are uneven
    double mean_ = 0;
    double largestCutoff_upr_;
    std::vector<std::complex<double>> fit_;  ///< empty: not computed yet
};

}  // namespace lathelier::signal
