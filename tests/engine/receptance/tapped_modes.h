// Known modes hit by half-sine pulses: force and motion over time in closed form, for the tests of impact tests.
#pragma once

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/receptance/tap/tap.h"

namespace lathelier::testing {

struct TappedMode {
    double frequency_hz, damping_ratio, stiffness_N_mm;

    double natural_rad_s() const { return 2 * std::numbers::pi * frequency_hz; }
    double mass_t() const { return stiffness_N_mm / (natural_rad_s() * natural_rad_s()); }
};

struct HalfSine {
    double start_s, length_s, peak_N;
};

/// ∫ sin(Ωτ) exp(-λτ) dτ from 0 to u.
inline std::complex<double> sineIntegral(double omega, std::complex<double> pole, double u)
{
    return (omega - std::exp(-pole * u) * (pole * std::sin(omega * u) + omega * std::cos(omega * u))) /
           (pole * pole + omega * omega);
}

inline double forceOf(const HalfSine& pulse, double time_s)
{
    const double since = time_s - pulse.start_s;
    return since <= 0 || since >= pulse.length_s ? 0
                                                 : pulse.peak_N * std::sin(std::numbers::pi * since / pulse.length_s);
}

/// Duhamel's integral of one mode: displacement, velocity or acceleration by `derivative` 0, 1, 2.
inline double motionOf(const TappedMode& mode, const HalfSine& pulse, double time_s, int derivative)
{
    const double since = time_s - pulse.start_s;
    if (since <= 0) return 0;
    const double natural = mode.natural_rad_s(), sigma = mode.damping_ratio * natural;
    if (sigma * since > 40) return 0;  // at rest again
    const double damped = natural * std::sqrt(1 - mode.damping_ratio * mode.damping_ratio);
    const std::complex<double> pole(-sigma, damped);
    const std::complex<double> state =
        std::exp(pole * since) * pulse.peak_N *
        sineIntegral(std::numbers::pi / pulse.length_s, pole, std::min(since, pulse.length_s)) /
        (mode.mass_t() * damped);
    const double place = state.imag(), speed = (pole * state).imag();
    if (derivative == 0) return place;
    if (derivative == 1) return speed;
    return forceOf(pulse, time_s) / mode.mass_t() - 2 * sigma * speed - natural * natural * place;
}

/// Receptance at s = iω + decay.
inline std::complex<double> trueReceptance(const std::vector<TappedMode>& modes, double frequency_hz, double decay = 0)
{
    const std::complex<double> s(decay, 2 * std::numbers::pi * frequency_hz);
    std::complex<double> sum = 0;
    for (const TappedMode& mode : modes) {
        const double natural = mode.natural_rad_s();
        sum += 1.0 / (mode.mass_t() * (s * s + 2 * mode.damping_ratio * natural * s + natural * natural));
    }
    return sum;
}

/// A record of pulses on resting modes, with white noise.
struct Tapping {
    std::vector<TappedMode> modes{{223, 0.02, 12000}, {790, 0.015, 40000}};
    std::vector<HalfSine> pulses;
    double rate_hz = 25600;
    double duration_s = 1;
    int derivative = 2;
    double force_noise = 0, motion_noise = 0;  ///< standard deviations
    std::uint64_t seed = 1;
    double force_offset = 0, motion_offset = 0;

    receptance::TapSignals record() const
    {
        receptance::TapSignals made;
        made.path = "test";
        made.rate_hz = rate_hz;
        const auto samples = static_cast<std::size_t>(std::llround(duration_s * rate_hz));
        for (std::size_t i = 0; i < samples; ++i) {
            const double time_s = static_cast<double>(i) / rate_hz;
            double force = force_offset + force_noise * randomNormal(seed, 1, i);
            double motion = motion_offset + motion_noise * randomNormal(seed, 2, i);
            for (const HalfSine& pulse : pulses) {
                force += forceOf(pulse, time_s);
                for (const TappedMode& mode : modes) motion += motionOf(mode, pulse, time_s, derivative);
            }
            made.force_N.push_back(force);
            made.motion.push_back(motion);
        }
        return made;
    }
};

}  // namespace lathelier::testing
