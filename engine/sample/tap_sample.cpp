#include "engine/sample/tap_sample.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/core/json.h"
#include "engine/core/random.h"

namespace lathelier::sample {
namespace {

constexpr char syntheticTap[] = "synthetic: tap test made by Lathelier, not a measurement";
constexpr double rate_hz = 10240;
constexpr double pulse_s = 0.9e-3;
constexpr double hitDistance_s = 0.4;
constexpr double firstHit_s = 0.05;
constexpr double forceNoise_N = 0.05;
constexpr double sensorNoise_m_s2 = 0.05;

struct TapMode {
    double frequency_hz, damping_ratio, stiffness_N_mm;
};
constexpr TapMode tapModes[]{{223, 0.03, 12000}, {790, 0.02, 40000}};

struct TapPulse {
    double start_s, peak_N;
};

/// The fourth hit is a double one.
std::vector<TapPulse> tapPulses()
{
    std::vector<TapPulse> pulses;
    constexpr double peaks_N[] = {212, 187, 240, 205, 196};
    for (const double peak : peaks_N)
        pulses.push_back({firstHit_s + hitDistance_s * static_cast<double>(pulses.size()) + 3e-5, peak});
    constexpr double bounce_s = 0.012, bounce_N = 41;
    pulses.push_back({pulses[3].start_s + bounce_s, bounce_N});
    return pulses;
}

double pulseForce(const TapPulse& pulse, double time_s)
{
    const double since = time_s - pulse.start_s;
    return since > 0 && since < pulse_s ? pulse.peak_N * std::sin(std::numbers::pi * since / pulse_s) : 0;
}

/// Acceleration in mm/s² of a mode at rest after a force sin(Ωt) of 1 N began: that of the steady motion and of the
/// free one that starts it from rest.
double accelerationOfSine(const TapMode& mode, double drive_rad_s, double since_s)
{
    if (since_s <= 0) return 0;
    using Complex = std::complex<double>;
    const double natural = 2 * std::numbers::pi * mode.frequency_hz;
    const double r = drive_rad_s / natural;
    const Complex steady = 1.0 / (mode.stiffness_N_mm * Complex(1 - r * r, 2 * mode.damping_ratio * r));
    const double sigma = mode.damping_ratio * natural;
    const double damped = natural * std::sqrt(1 - mode.damping_ratio * mode.damping_ratio);
    const double place = -steady.imag(), speed = -drive_rad_s * steady.real();
    const Complex free(place, -(speed + sigma * place) / damped);
    const Complex pole(-sigma, damped);
    return -drive_rad_s * drive_rad_s * (steady * std::polar(1.0, drive_rad_s * since_s)).imag() +
           (pole * pole * free * std::exp(pole * since_s)).real();
}

/// A half-sine is a sine from its start and another one from its end.
double accelerationOf(const TapPulse& pulse, double time_s)
{
    double sum = 0;
    for (const TapMode& mode : tapModes)
        for (const double start_s : {pulse.start_s, pulse.start_s + pulse_s})
            sum += pulse.peak_N * accelerationOfSine(mode, std::numbers::pi / pulse_s, time_s - start_s);
    return sum;
}

SampleContent makeTap(std::uint64_t seed, const Progress& progress)
{
    constexpr std::uint64_t forceStream = 71, sensorStream = 72;
    const std::vector<TapPulse> pulses = tapPulses();
    const auto samples = static_cast<std::size_t>((firstHit_s + 5 * hitDistance_s) * rate_hz);
    std::string text = "# synthetic=true\n# two modes tapped with a hammer\ntime_s,force_N,acceleration_m_s2\n";
    for (std::size_t i = 0; i < samples; ++i) {
        if (i % 1024 == 0) progress.report(static_cast<double>(i) / static_cast<double>(samples));
        const double time_s = static_cast<double>(i) / rate_hz;
        double force = forceNoise_N * randomNormal(seed, forceStream, i);
        double acceleration = sensorNoise_m_s2 * randomNormal(seed, sensorStream, i);
        for (const TapPulse& pulse : pulses) {
            force += pulseForce(pulse, time_s);
            acceleration += 1e-3 * accelerationOf(pulse, time_s);
        }
        text += fmt::format("{:.8f},{:.3f},{:.4f}\n", time_s, force, acceleration);
    }
    SampleContent content;
    content.texts = {std::move(text)};
    Json modes = Json::array();
    for (const TapMode& mode : tapModes)
        modes.push_back({{"frequency_hz", mode.frequency_hz},
                         {"damping_ratio", mode.damping_ratio},
                         {"stiffness_N_mm", mode.stiffness_N_mm}});
    content.truth = std::make_shared<Json>(
        Json{{"tap_record", {{"about", syntheticTap}, {"modes", std::move(modes)}, {"hits", 5}, {"double_hit", 4}}}});
    return content;
}

}  // namespace

const SamplePart& tapSample()
{
    static const SamplePart part{"tap", {"tap_record.csv"}, makeTap};
    return part;
}

}  // namespace lathelier::sample
