// A closed profile as a function of the angle: uniform sampling, harmonics, Gaussian filter.
// Source: ISO 16610-21 (Gaussian filter), ISO 12181-2 (cut-offs in undulations per revolution).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace lathelier {

/// Transmission of the closed Gaussian low pass at `upr` undulations per revolution: 2^-(upr/cutoff)².
double gaussianTransmission(double upr, double cutoff_upr);

/// What passes: everything, all up to `high_upr` (long-wave pass), all above `low_upr`, or the band between.
struct ProfileBand {
    std::optional<double> low_upr;   ///< waves longer than this are damped (short-wave pass)
    std::optional<double> high_upr;  ///< waves shorter than this are damped (long-wave pass)

    bool isAll() const { return !low_upr && !high_upr; }
    double transmission(double upr) const;
    friend bool operator==(const ProfileBand&, const ProfileBand&) = default;
};

/// Filters values at uniform angles over one whole turn. The mean passes always: it is the size, not the form.
std::vector<double> filterClosed(std::span<const double> values, const ProfileBand& band);

/// One harmonic; r contains amplitude · cos(upr · θ - phase).
struct Harmonic {
    int upr = 0;
    double amplitude = 0;  ///< zero to peak, in the unit of the values
    double phase_rad = 0;
};

/// Harmonics k = 1…limit of values at uniform angles, limit ≤ n/2.
std::vector<Harmonic> harmonicsUniform(std::span<const double> values, int limit);

/// The same by least squares for any angles (with gaps, duplicates, any order); ill-conditioned orders are left out:
/// the result may be shorter than `limit`.
std::vector<Harmonic> harmonicsAt(std::span<const double> angle_rad, std::span<const double> values, int limit);

/// Samples per cut-off wave below which a filter's answer is not trusted (ISO 12181-2: 7).
inline constexpr double samplesPerCutoff = 7;

}  // namespace lathelier
