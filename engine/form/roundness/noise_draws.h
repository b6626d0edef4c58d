// Draws of the noise of a profile's points, for Monte Carlo: white or by its spectrum, with spikes and rounding,
// filtered. Source: JCGM 101.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/random.h"
#include "engine/form/roundness/point_noise.h"
#include "engine/form/roundness/prepared_profile.h"
#include "engine/signal/fourier.h"

namespace lathelier::form {

inline constexpr std::uint64_t drawSeed = 12181;  ///< arbitrary, fixed for reproducibility

/// Stride of the points that represent the draws. Filtered noise is smooth: for a long profile 100 points per cut-off
/// wavelength resolve its extremes. 1 where values are rounded or have spikes, which are drawn point by point.
std::size_t strideOf(const PointNoise& noise, const signal::TransmissionBand& band, std::size_t points);

/// Draws of noise on every `stride`th of the points, in mm, filtered. Assumes nearly even spacing. Keeps references to
/// `noise` and `band`.
class NoiseDraws {
public:
    NoiseDraws(const PreparedProfile& prepared, const PointNoise& noise, const signal::TransmissionBand& band,
               std::size_t stride);

    /// Independent points without rounding, spikes and filter: each can be drawn by itself.
    static bool isPlain(const PointNoise& noise, const signal::TransmissionBand& band)
    {
        return band.isAll() && noise.power_um2.empty() && noise.spikes_um.empty() && noise.resolution_um == 0;
    }

    double plain_mm(std::uint64_t draw, std::size_t i) const
    {
        return noise_.beyond_rounding_um / 1000 * randomNormal(drawSeed, draw, i);
    }

    /// The same where it can make a point a contact of the zone, else 0.
    double plainBeyond_mm(std::uint64_t draw, std::size_t i, double rarity) const
    {
        return noise_.beyond_rounding_um / 1000 * randomNormalBeyond(drawSeed, draw, i, rarity);
    }

    /// All points of one draw, in mm. Throws Cancelled.
    std::vector<double> operator()(std::uint64_t draw, const Progress& progress) const;

private:
    void addSpikes(std::uint64_t draw, std::vector<double>& drawn) const;
    /// Quantisation with a random offset: its effect depends on the curvature of the form at its extremes.
    void roundOff(std::uint64_t draw, std::vector<double>& drawn) const;
    std::vector<double> filtered(const std::vector<double>& drawn, const Progress& progress) const;

    const PointNoise& noise_;
    const signal::TransmissionBand& band_;
    std::size_t n_;
    bool byOrders_;    ///< noise is drawn as Fourier coefficients
    bool isFiltered_;  ///< the coefficients are those of the filtered noise
    signal::FourierTransform transform_;
    std::vector<double> amplitude_mm_, transmission_;
};

}  // namespace lathelier::form
