#include "engine/training/decay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::training {
namespace {

constexpr double samplesPerPeriod = 96;  ///< of the highest mode
constexpr double mostSamples = 5e6;
constexpr double impulse_N_s = 1;

}  // namespace

Decay ringDown(std::span<const stability::Mode> modes, double seconds)
{
    double highest_hz = 0;
    for (const stability::Mode& mode : modes) highest_hz = std::max(highest_hz, mode.frequency_hz);
    Decay decay;
    decay.step_s = 1 / (samplesPerPeriod * highest_hz);
    const double count = std::clamp(std::ceil(seconds / decay.step_s), 1.0, mostSamples);
    decay.deflection_mm.assign(static_cast<std::size_t>(count), 0.0);
    for (const stability::Mode& mode : modes) {
        const double omega = 2 * std::numbers::pi * mode.frequency_hz, rate = mode.damping_ratio * omega;
        const double damped = omega * std::sqrt(1 - mode.damping_ratio * mode.damping_ratio);
        const double size = impulse_N_s * omega * omega / (mode.stiffness_N_mm * damped);
        for (std::size_t i = 0; i < decay.deflection_mm.size(); ++i) {
            const double t = decay.step_s * static_cast<double>(i);
            decay.deflection_mm[i] += size * std::exp(-rate * t) * std::sin(damped * t);
        }
    }
    return decay;
}

std::vector<Peak> peaksOf(const Decay& decay)
{
    std::vector<Peak> peaks;
    const std::vector<double>& x = decay.deflection_mm;
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        if (!(x[i] > 0) || x[i] <= x[i - 1] || x[i] < x[i + 1]) continue;
        const double slope = (x[i + 1] - x[i - 1]) / 2, bend = x[i + 1] - 2 * x[i] + x[i - 1];
        const double shift = bend < 0 ? -slope / bend : 0;
        peaks.push_back({(static_cast<double>(i) + shift) * decay.step_s, x[i] + slope * shift / 2});
    }
    return peaks;
}

double logDecrement(double first_mm, double last_mm, int periods)
{
    return std::log(first_mm / last_mm) / periods;
}

double dampingRatio(double log_decrement)
{
    return log_decrement / std::hypot(2 * std::numbers::pi, log_decrement);
}

report::Plot decayPlot(const Decay& decay)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Decay after a blow");
    plot.x = {LT_TEXT("Engine", "Time"), unit::s};
    plot.y = {LT_TEXT("Engine", "Deflection"), unit::mm};
    report::Curve curve;
    curve.x.reserve(decay.deflection_mm.size());
    for (std::size_t i = 0; i < decay.deflection_mm.size(); ++i)
        curve.x.push_back(decay.step_s * static_cast<double>(i));
    curve.y = decay.deflection_mm;
    plot.curves = {std::move(curve)};
    return plot;
}

}  // namespace lathelier::training
