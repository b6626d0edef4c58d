#include "engine/stability/simulation/characteristic_root.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace lathelier::stability {
namespace {

using Complex = std::complex<double>;

constexpr double startsPerTurn = 6;    ///< start values per turn of e^{iωT}
constexpr double beyondHighest = 1.6;  ///< last start over the highest natural frequency
constexpr int mostRootSteps = 60;
constexpr double farthest = 40;      ///< bound of |Re(s)| T
constexpr double converged = 1e-12;  ///< last step over the size of the root

/// Newton's step for the equation times all denominators of G, which has no poles.
Complex newtonStep(std::span<const Mode> modes, const CutForces& cut, double revolution_s, Complex s)
{
    Complex g = 0, g_slope = 0, poles = 0;
    for (const Mode& mode : modes) {
        const double compliance = cut.direction_factor / mode.stiffness_N_mm;
        if (!mode.hasMass()) {
            g += compliance;
            continue;
        }
        const double omega = 2 * std::numbers::pi * mode.frequency_hz;
        const Complex denominator = s * s + 2 * mode.damping_ratio * omega * s + omega * omega;
        const Complex slope = 2.0 * s + 2 * mode.damping_ratio * omega;
        const Complex one = compliance * omega * (omega + mode.lead * s) / denominator;
        g += one;
        g_slope += compliance * omega * mode.lead / denominator - one * slope / denominator;
        poles += slope / denominator;
    }
    const Complex delayed = std::exp(-s * revolution_s);
    const Complex force = cut.stiffness_N_mm * (1.0 - delayed) + s * cut.damping_N_s_mm;
    const Complex force_slope = cut.stiffness_N_mm * revolution_s * delayed + cut.damping_N_s_mm;
    const Complex value = 1.0 + g * force;
    return value / (g_slope * force + g * force_slope + value * poles);
}

std::optional<Complex> rootFrom(std::span<const Mode> modes, const CutForces& cut, double revolution_s, Complex s)
{
    for (int step = 0; step < mostRootSteps; ++step) {
        const Complex change = newtonStep(modes, cut, revolution_s, s);
        s -= change;
        if (!std::isfinite(s.real()) || !std::isfinite(s.imag()) || std::abs(s.real()) * revolution_s > farthest)
            return std::nullopt;
        if (std::abs(change) <= converged * (std::abs(s) + 1 / revolution_s)) return s;
    }
    return std::nullopt;
}

}  // namespace

Growth growthOfRoots(std::span<const Mode> modes, const CutForces& cut, double revolution_s, const Progress& progress)
{
    const double highest_hz = highestFrequency(modes);
    const double last = 2 * std::numbers::pi * beyondHighest * highest_hz + 2 * std::numbers::pi / revolution_s;
    const double spacing = 2 * std::numbers::pi / (startsPerTurn * revolution_s);
    const double starts = std::ceil(last / spacing);
    std::optional<Complex> rightmost;
    const auto tryFrom = [&](Complex start) {
        progress.check();
        const std::optional<Complex> root = rootFrom(modes, cut, revolution_s, start);
        if (root && (!rightmost || root->real() > rightmost->real())) rightmost = root;
    };
    for (double i = 0; i <= starts; ++i) tryFrom({0, i * spacing});
    for (const Mode& mode : modes) {
        if (!mode.hasMass()) continue;
        const double omega = 2 * std::numbers::pi * mode.frequency_hz;
        tryFrom({-mode.damping_ratio * omega, omega});
    }
    if (!rightmost) return {};
    return {std::exp(rightmost->real() * revolution_s), std::abs(rightmost->imag()) / (2 * std::numbers::pi)};
}

}  // namespace lathelier::stability
