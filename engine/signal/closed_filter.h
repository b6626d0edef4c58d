// Several filters of the same closed profile: what they share is computed once.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "engine/signal/closed_profile.h"

namespace lathelier::signal {

/// filterClosedAt() for the same values and several bands. The trigonometric polynomial that fits the values is made
/// once, with the orders that the largest cut-off needs.
class ClosedFilter {
public:
    /// `values` in the order of the sampling, which has to stay.
    ClosedFilter(const AngularSampling& sampling, std::vector<double> values, double largest_cutoff_upr);

    /// The answer in the order of the sampling. Throws Cancelled.
    FilteredValues operator()(const TransmissionBand& band, const Progress& progress = {});

    /// The answer at `count` even angles from 0, where the series serves and holds no shorter waves than they carry;
    /// else nothing.
    std::optional<std::vector<double>> even(const TransmissionBand& band, std::size_t count,
                                            const Progress& progress = {});

private:
    bool bySeries(const TransmissionBand& band, const Progress& progress, std::vector<double>& result);
    std::vector<std::complex<double>> passed(const TransmissionBand& band, const Progress& progress);

    const AngularSampling& sampling_;
    std::vector<double> values_;  ///< without their mean where angles are uneven
    double mean_ = 0;
    double largest_cutoff_upr_;
    std::vector<std::complex<double>> fit_;  ///< empty: not made yet
};

}  // namespace lathelier::signal
