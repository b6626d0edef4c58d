#include "engine/form/roundness/noise_draws.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace lathelier::form {

std::size_t strideOf(const PointNoise& noise, const signal::TransmissionBand& band, std::size_t points)
{
    constexpr double pointsPerWave = 100;
    constexpr std::size_t least = 8192;
    if (!band.high_upr || !noise.spikes_um.empty() || noise.resolution_um > 0) return 1;
    return std::max<std::size_t>(
        1, points / std::max(least, static_cast<std::size_t>(std::ceil(pointsPerWave * *band.high_upr))));
}

NoiseDraws::NoiseDraws(const PreparedProfile& prepared, const PointNoise& noise, const signal::TransmissionBand& band,
                       std::size_t stride)
    : noise_(noise),
      band_(band),
      n_((prepared.distance_mm.size() + stride - 1) / stride),
      byOrders_(stride > 1 || !noise.power_um2.empty()),
      isFiltered_(stride > 1),
      transform_(isPlain(noise, band) ? 1 : n_)
{
    if (isPlain(noise, band)) return;
    // The sequence of points covers the turn except for its gaps.
    const double covered = 1 - prepared.sampling.missing_rad / (2 * std::numbers::pi);
    for (std::size_t m = 0; m <= n_ / 2; ++m)
        transmission_.push_back(m == 0 ? 1 : band.transmission(static_cast<double>(m) / covered));
    if (!byOrders_) return;
    const double share = noise.sigma_um > 0 ? noise.beyond_rounding_um / noise.sigma_um : 0;
    const double white = 4 * noise.sigma_um * noise.sigma_um / static_cast<double>(prepared.distance_mm.size());
    for (std::size_t m = 0; m <= n_ / 2; ++m) {
        const double power = noise.power_um2.empty() ? white : noise.power_um2[m];
        // Half the amplitude: the other half belongs to the conjugate order.
        amplitude_mm_.push_back(share * std::sqrt(power / 2) / 2000 * (isFiltered_ ? transmission_[m] : 1));
    }
}

std::vector<double> NoiseDraws::operator()(std::uint64_t draw, const Progress& progress) const
{
    progress.check();
    std::vector<double> drawn(n_);
    if (!byOrders_) {
        for (std::size_t i = 0; i < n_; ++i) drawn[i] = plain_mm(draw, i);
    } else {
        std::vector<std::complex<double>> spectrum(amplitude_mm_.size());
        for (std::size_t m = 0; m < spectrum.size(); ++m)
            spectrum[m] = amplitude_mm_[m] * std::complex<double>(randomNormal(drawSeed, draw, 2 * m),
                                                                  randomNormal(drawSeed, draw, 2 * m + 1));
        drawn = transform_.series(spectrum);
    }
    progress.check();
    if (!noise_.spikes_um.empty()) addSpikes(draw, drawn);
    if (noise_.resolution_um > 0) roundOff(draw, drawn);
    progress.check();
    return band_.isAll() || isFiltered_ ? drawn : filtered(drawn, progress);
}

void NoiseDraws::addSpikes(std::uint64_t draw, std::vector<double>& drawn) const
{
    const auto count = static_cast<double>(noise_.spikes_um.size());
    for (std::size_t i = 0; i < n_; ++i) {
        if (randomUniform(drawSeed + 1, draw, i) >= count / static_cast<double>(n_)) continue;
        const auto which = static_cast<std::size_t>(randomUniform(drawSeed + 2, draw, i) * count);
        drawn[i] += noise_.spikes_um[which] / 1000;
    }
}

void NoiseDraws::roundOff(std::uint64_t draw, std::vector<double>& drawn) const
{
    const double step = noise_.resolution_um / 1000, offset = step * randomUniform(drawSeed + 3, draw, 0);
    for (std::size_t i = 0; i < n_; ++i) {
        const double form = noise_.form_um[i] / 1000 + offset;
        drawn[i] = step * std::round((form + drawn[i]) / step) - form;
    }
}

std::vector<double> NoiseDraws::filtered(const std::vector<double>& drawn, const Progress& progress) const
{
    std::vector<std::complex<double>> spectrum = transform_.forward(drawn);
    progress.check();
    for (std::size_t m = 0; m < spectrum.size(); ++m) spectrum[m] *= transmission_[m] / static_cast<double>(n_);
    return transform_.series(spectrum);
}

}  // namespace lathelier::form
