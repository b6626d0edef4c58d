// A closed profile as a function of the angle and its Gaussian filter; its harmonics: harmonics.h.
// Source: ISO 16610-21 (Gaussian filter), ISO 12181-2 (cut-offs in undulations per revolution).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/core/progress.h"
#include "engine/signal/angular_sampling.h"

namespace lathelier::signal {

/// Transmission of the closed Gaussian low pass at `upr` undulations per revolution: 2^-(upr/cutoff)².
double gaussianTransmission(double upr, double cutoff_upr);

/// What passes: everything, all up to `high_upr` (long-wave pass), all above `low_upr`, or the band between.
struct TransmissionBand {
    std::optional<double> low_upr;   ///< waves longer than this are damped (short-wave pass)
    std::optional<double> high_upr;  ///< waves shorter than this are damped (long-wave pass)

    bool isAll() const { return !low_upr && !high_upr; }
    double transmission(double upr) const;
    friend bool operator==(const TransmissionBand&, const TransmissionBand&) = default;
};

/// Filters values at uniform angles over one whole turn. The mean passes always: it is the size, not the form.
std::vector<double> filterClosed(std::span<const double> values, const TransmissionBand& band);

/// How values at given angles were filtered.
enum class FilterMethod {
    Uniform,    ///< even angles: exact
    Series,     ///< uneven angles: exact for waves that the spacing carries
    Regression  ///< gaps: Gaussian-weighted straight lines, which do not ring beside a gap
};

struct FilteredValues {
    std::vector<double> values;                   ///< at the given angles, in the given order
    FilterMethod method = FilterMethod::Uniform;  ///< how it was done
};

/// Filters values at any angles (any order, gaps, duplicates); the answer stands at the same angles. Where no gap
/// hinders, the values are taken as a trigonometric polynomial; beside gaps, as Gaussian regression of order one (away
/// from gaps the same as the Gaussian filter).
FilteredValues filterClosedAt(std::span<const double> angle_rad, std::span<const double> values,
                              const TransmissionBand& band);

/// The same for values in the order of a sampling; the answer stands in that order.
FilteredValues filterClosedAt(const AngularSampling& sampling, std::vector<double> values, const TransmissionBand& band,
                              const Progress& progress = {});

/// Samples per cut-off wave below which a filter's answer is not trusted (ISO 12181-2: 7).
inline constexpr double samplesPerCutoff = 7;

}  // namespace lathelier::signal
