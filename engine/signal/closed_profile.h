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

/// Transmission band: everything, all up to `high_upr` (long-wave pass), all above `low_upr` (short-wave pass), or the
/// band between.
struct TransmissionBand {
    std::optional<double> low_upr;   ///< waves longer than this are damped (short-wave pass)
    std::optional<double> high_upr;  ///< waves shorter than this are damped (long-wave pass)

    bool isAll() const { return !low_upr && !high_upr; }
    double transmission(double upr) const;
    friend bool operator==(const TransmissionBand&, const TransmissionBand&) = default;
};

/// Filters values at uniform angles over one whole turn. The mean is always transmitted, since it is size and not form.
std::vector<double> filterClosed(std::span<const double> values, const TransmissionBand& band);

/// Filter method for values at given angles.
enum class FilterMethod {
    Uniform,    ///< even angles: exact
    Series,     ///< uneven angles: exact for waves determined by the spacing
    Regression  ///< gaps: Gaussian-weighted straight lines, without ringing beside a gap
};

struct FilteredValues {
    std::vector<double> values;                   ///< at the given angles, in the given order
    FilterMethod method = FilterMethod::Uniform;  ///< method applied
};

/// Filters values at any angles (any order, gaps, duplicates); the result is at the same angles. Without gaps by a
/// trigonometric polynomial; beside gaps by Gaussian regression of order one (away from gaps the same as the Gaussian
/// filter).
FilteredValues filterClosedAt(std::span<const double> angle_rad, std::span<const double> values,
                              const TransmissionBand& band);

/// The same for values in the order of a sampling; the result has that order.
FilteredValues filterClosedAt(const AngularSampling& sampling, std::vector<double> values, const TransmissionBand& band,
                              const Progress& progress = {});

/// Least samples per cut-off wave (ISO 12181-2: 7).
inline constexpr double samplesPerCutoff = 7;

}  // namespace lathelier::signal
