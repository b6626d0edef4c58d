#include "engine/signal/harmonics.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/signal/angular_sampling.h"
#include "engine/signal/closed_profile.h"
#include "engine/signal/fourier.h"
#include "engine/signal/fourier_fit.h"
#include "engine/signal/nonuniform_fourier.h"

namespace lathelier::signal {
namespace {

using Complex = std::complex<double>;

/// c_k e^{ikθ} + its conjugate is 2|c_k| cos(kθ + arg c_k).
Harmonic harmonic(int upr, Complex coefficient)
{
    return {upr, 2 * std::abs(coefficient), -std::arg(coefficient)};
}

/// The order n/2 of n values: cosine and sine are not separable there, so the smallest amplitude that explains the
/// values is taken.
Harmonic alternating(int upr, const AngularSampling& sampling, const std::vector<double>& values)
{
    double cc = 0, cs = 0, ss = 0, c = 0, s = 0;
    for (std::size_t j = 0; j < values.size(); ++j) {
        const double angle = upr * sampling.angle_rad[j];
        const double x = std::cos(angle), y = std::sin(angle), w = sampling.weight[j];
        cc += w * x * x;
        cs += w * x * y;
        ss += w * y * y;
        c += w * x * values[j];
        s += w * y * values[j];
    }
    // Pseudo-inverse along the observable direction.
    const double direction = std::atan2(2 * cs, cc - ss) / 2;
    const double ux = std::cos(direction), uy = std::sin(direction);
    const double strength = ux * ux * cc + 2 * ux * uy * cs + uy * uy * ss;
    const double amplitude = strength > 0 ? (ux * c + uy * s) / strength : 0;
    return {upr, std::abs(amplitude),
            amplitude >= 0 ? direction : std::remainder(direction + std::numbers::pi, 2 * std::numbers::pi)};
}

}  // namespace

std::vector<Harmonic> harmonicsUniform(std::span<const double> values, int limit)
{
    std::vector<Harmonic> result;
    const std::size_t n = values.size();
    if (n < 2) return result;
    double mean = 0;
    for (const double value : values) mean += value / static_cast<double>(n);
    std::vector<double> form(values.begin(), values.end());
    for (double& value : form) value -= mean;
    const std::vector<Complex> spectrum = FourierTransform(n).forward(form);
    for (int k = 1; k <= std::min(limit, static_cast<int>(n / 2)); ++k) {
        const bool last = 2 * static_cast<std::size_t>(k) == n;
        const Complex coefficient = spectrum[static_cast<std::size_t>(k)] / static_cast<double>(n);
        result.push_back(harmonic(k, last ? coefficient / 2.0 : coefficient));
    }
    return result;
}

std::vector<Harmonic> harmonicsAt(std::span<const double> angle_rad, std::span<const double> values, int limit)
{
    if (values.size() < 3) return {};
    const AngularSampling sampling = sampleAngles(angle_rad);
    return harmonicsAt(sampling, inOrder(sampling, values), limit);
}

std::vector<Harmonic> harmonicsAt(const AngularSampling& sampling, std::vector<double> values, int limit,
                                  const Progress& progress)
{
    std::vector<Harmonic> result;
    if (values.size() < 3) return result;
    if (sampling.uniform) {
        result = harmonicsUniform(values, limit);
        for (Harmonic& h : result)
            h.phase_rad = std::remainder(h.phase_rad + h.upr * sampling.angle_rad[0], 2 * std::numbers::pi);
        return result;
    }
    if (sampling.largest_gap_rad > 2 * std::numbers::pi / 3) return result;

    double mean = 0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    for (double& value : values) value -= mean;
    const std::vector<Complex> fit = fitFourier(sampling, values, limit, progress);
    for (std::size_t k = 1; k < fit.size(); ++k) result.push_back(harmonic(static_cast<int>(k), fit[k]));
    limit = std::min(limit, carriedOrders(sampling).estimated);
    if (static_cast<int>(result.size()) >= limit) return result;

    const std::vector<double> explained = fourierSeries(fit, sampling.angle_rad, progress);
    double total = 0;
    std::vector<double> rest(values.size()), weighted(values.size());
    for (std::size_t j = 0; j < values.size(); ++j) {
        rest[j] = values[j] - explained[j];
        weighted[j] = sampling.weight[j] * rest[j];
        total += sampling.weight[j];
    }
    const std::vector<Complex> sums = fourierSums(sampling.angle_rad, weighted, limit, progress);
    for (int k = static_cast<int>(fit.size()); k <= limit; ++k)
        result.push_back(2 * static_cast<std::size_t>(k) == sampling.different
                             ? alternating(k, sampling, rest)
                             : harmonic(k, sums[static_cast<std::size_t>(k)] / total));
    return result;
}

}  // namespace lathelier::signal
