#include "engine/stability/lobe_uncertainty.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/stability/envelope.h"
#include "engine/stability/modes.h"
#include "engine/stability/slow_lobes.h"

namespace lathelier::stability {
namespace {

constexpr std::size_t draws = 1000;
constexpr double widest = 1.5;             ///< bound of sampled factors
constexpr double widestDamping = 4;        ///< of the factor of a damping ratio
constexpr double widestNoise = 5;          ///< of the depth's factor by noise
constexpr std::size_t mostSpeeds = 500;    ///< at which machines are drawn; between them quantiles are interpolated
constexpr LineDensity coarse{6, 8, 1.01};  ///< of the response of a drawn machine
constexpr double beyondModes = 3;          ///< last line over the highest natural frequency, at least
constexpr double belowModes = 0.3;         ///< first line over the lowest one

/// Streams of random numbers; those of modes follow behind.
enum Stream : std::uint64_t { Frequency = 1, Compliance = 2, Coefficient = 3, Noise = 4, Modes = 10 };

constexpr std::uint64_t perMode = 6;  ///< streams

/// Factor of machine `number` for a standard uncertainty in percent.
double factorOf(std::uint64_t stream, std::size_t number, double percent)
{
    return std::clamp(1 + percent / 100 * randomNormal(1, stream, number), 1 / widest, widest);
}

double coefficientFactor(const LobeParameters& p, std::size_t number)
{
    return p.cutting_coefficient_N_mm2 ? factorOf(Coefficient, number, p.uncertainty_coefficient_percent) : 1;
}

/// Speeds of the limit at which machines are drawn.
std::vector<double> drawnSpeeds(const LobeLimit& limit)
{
    if (limit.speed_rpm.size() <= mostSpeeds) return limit.speed_rpm;
    std::vector<double> speeds;
    const double from = limit.speed_rpm.front(), to = limit.speed_rpm.back();
    for (std::size_t i = 0; i < mostSpeeds; ++i)
        speeds.push_back(from + (to - from) * static_cast<double>(i) / (mostSpeeds - 1));
    return speeds;
}

/// Position of a speed among evenly spaced ones: the index below, and the share of the step.
std::pair<std::size_t, double> placeOf(const std::vector<double>& speed_rpm, double speed)
{
    const double step = (speed_rpm.back() - speed_rpm.front()) / static_cast<double>(speed_rpm.size() - 1);
    const double place = std::clamp((speed - speed_rpm.front()) / step, 0.0, static_cast<double>(speed_rpm.size() - 1));
    const std::size_t below = std::min(static_cast<std::size_t>(place), speed_rpm.size() - 2);
    return {below, place - static_cast<double>(below)};
}

/// Between two depths, of which either may be infinite.
double between(double a, double b, double share)
{
    if (share <= 0) return a;
    if (share >= 1) return b;
    return std::isinf(a) || std::isinf(b) ? HUGE_VAL : a + share * (b - a);
}

/// Quantiles at the speeds of the limit of a band that holds its machines.
void takeQuantiles(LobeBand& band, const LobeLimit& limit)
{
    const std::size_t speeds = band.drawn_rpm.size();
    std::vector<double> low(speeds), high(speeds);
    parallelFor(speeds, 16, {}, [&](std::size_t begin, std::size_t end) {
        std::vector<float> depths(draws);
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t number = 0; number < draws; ++number) depths[number] = band.drawn[number * speeds + i];
            low[i] = quantileInPlace(depths, 0.025);
            high[i] = quantileInPlace(depths, 0.975);
        }
    });
    const auto finite = [](double depth) { return std::isfinite(depth) ? depth : notANumber; };
    for (const double speed : limit.speed_rpm) {
        const auto [i, share] = speeds > 1 ? placeOf(band.drawn_rpm, speed) : std::pair<std::size_t, double>{0, 0};
        const std::size_t next = std::min(i + 1, speeds - 1);
        band.low_mm.push_back(finite(between(low[i], low[next], share)));
        band.high_mm.push_back(finite(between(high[i], high[next], share)));
    }
}

/// A machine whose modes err; the frequencies of its response.
receptance::ModalModel drawnModel(const LobeParameters& p, const receptance::UncertainModel& modes, std::size_t number)
{
    receptance::ModalModel model = modes.model;
    for (std::size_t m = 0; m < model.modes.size(); ++m) {
        receptance::ModalMode& mode = model.modes[m];
        const receptance::ModeUncertainty own = m < modes.own.size() ? modes.own[m] : receptance::ModeUncertainty{};
        const auto normal = [&](std::uint64_t which) { return randomNormal(1, Modes + perMode * m + which, number); };
        // What is stated errs by itself; of a fit the errors of damping and stiffness go together.
        const auto factor = [](double stated_percent, double stated, double share, double of_fit, double bound) {
            return std::clamp(1 + stated_percent / 100 * stated + share * of_fit, 1 / bound, bound);
        };
        const double damping = normal(4);
        const double stiffness =
            own.correlation * damping + std::sqrt(1 - own.correlation * own.correlation) * normal(5);
        const double stiffness_share = own.stiffness_N_mm / std::abs(mode.stiffness_N_mm);
        mode.stiffness_N_mm /= factor(p.uncertainty_compliance_percent, normal(2), 0, 0, widest);
        mode.stiffness_N_mm *= factor(0, 0, stiffness_share, stiffness, widest);
        mode.damping_ratio *= factor(p.uncertainty_damping_percent, normal(1), own.damping_ratio / mode.damping_ratio,
                                     damping, widestDamping);
        mode.frequency_hz *=
            factor(p.uncertainty_frequency_percent, normal(0), own.frequency_hz / mode.frequency_hz, normal(3), widest);
    }
    return model;
}

Boundary boundaryOfModel(const receptance::ModalModel& model, double factor, const Interval& range_hz)
{
    std::vector<Mode> modes;
    for (const receptance::ModalMode& mode : model.modes)
        modes.push_back({mode.frequency_hz, mode.damping_ratio, mode.stiffness_N_mm});
    return boundaryOf(receptance::synthesised(model, linesAround(modes, range_hz, coarse)), factor, 1);
}

}  // namespace

bool isUncertain(const LobeParameters& p, const receptance::UncertainModel& modes)
{
    return p.uncertainty_frequency_percent > 0 || p.uncertainty_compliance_percent > 0 ||
           p.uncertainty_damping_percent > 0 ||
           (p.cutting_coefficient_N_mm2 && p.uncertainty_coefficient_percent > 0) ||
           (modes.isKnown() && !modes.own.empty());
}

LobeBand bandOfWhole(const LobeParameters& p, const LobeLimit& limit, const std::vector<double>& noise,
                     const LimitOver& limitOver, const Progress& progress)
{
    LobeBand band;
    band.drawn_rpm = limit.speed_rpm;
    const std::size_t speeds = limit.speed_rpm.size();
    band.drawn.resize(draws * speeds);
    const LobeLimit whole =
        limitOver({limit.speed_rpm.front() / widest, limit.speed_rpm.back() * widest}, 2 * p.points);
    parallelFor(draws, 8, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t number = begin; number < end; ++number) {
            const double frequency = factorOf(Frequency, number, p.uncertainty_frequency_percent);
            const double compliance = factorOf(Compliance, number, p.uncertainty_compliance_percent);
            const double size = 1 / (compliance * coefficientFactor(p, number));
            const double noisy = randomNormal(1, Noise, number);
            for (std::size_t i = 0; i < speeds; ++i) {
                const double depth = depthAt(whole, limit.speed_rpm[i] / frequency);
                const double by_noise =
                    noise.empty() ? 1 : 1 / std::clamp(1 + noise[i] * noisy, 1 / widestNoise, widestNoise);
                band.drawn[number * speeds + i] =
                    static_cast<float>(std::isnan(depth) ? HUGE_VAL : size * by_noise * depth);
            }
        }
    });
    takeQuantiles(band, limit);
    return band;
}

LobeBand bandOfModes(const LobeParameters& p, const LobeLimit& limit, const receptance::UncertainModel& modes,
                     double per_N_mm, const Progress& progress)
{
    LobeBand band;
    band.drawn_rpm = drawnSpeeds(limit);
    const std::size_t speeds = band.drawn_rpm.size();
    band.drawn.resize(draws * speeds);
    double lowest = HUGE_VAL, highest = 0;
    for (const receptance::ModalMode& mode : modes.model.modes) {
        lowest = std::min(lowest, mode.frequency_hz);
        highest = std::max(highest, mode.frequency_hz);
    }
    // The lobe k = 0 carries frequencies up to N/60.
    Interval range_hz{belowModes * lowest, std::max(beyondModes * highest, 1.1 * limit.speed_rpm.back() / 60)};
    if (modes.range_hz) range_hz = *modes.range_hz;
    parallelFor(draws, 4, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t number = begin; number < end; ++number) {
            const LimitsBySpeed limits(boundaryOfModel(drawnModel(p, modes, number), p.direction_factor, range_hz),
                                       p.relation);
            const double per = per_N_mm / coefficientFactor(p, number);
            for (std::size_t i = 0; i < speeds; ++i)
                band.drawn[number * speeds + i] = static_cast<float>(per * limits.at(band.drawn_rpm[i]).depth_N_mm);
        }
    });
    takeQuantiles(band, limit);
    return band;
}

PointStability pointStabilityAt(const LobeResult& result, double speed_rpm, double depth_mm)
{
    PointStability point;
    const LobeLimit& limit = result.limit;
    point.limit_mm = depthAt(limit, speed_rpm);
    point.stable = !(depth_mm >= point.limit_mm);
    point.probability_stable = point.stable ? 1 : 0;
    if (limit.speed_rpm.size() < 2 || speed_rpm < limit.speed_rpm.front() || speed_rpm > limit.speed_rpm.back())
        return point;
    const double step = limit.speed_rpm[1] - limit.speed_rpm[0];
    const auto i = std::min(static_cast<std::size_t>(std::lround((speed_rpm - limit.speed_rpm.front()) / step)),
                            limit.speed_rpm.size() - 1);
    point.frequency_hz = limit.frequency_hz[i];
    point.k = limit.k[i];
    if (!result.band) return point;
    const LobeBand& band = *result.band;
    const std::size_t speeds = band.drawn_rpm.size();
    const auto [below, share] = placeOf(band.drawn_rpm, speed_rpm);
    int stable = 0;
    for (std::size_t number = 0; number < draws; ++number) {
        const float* const of_machine = band.drawn.data() + number * speeds + below;
        stable += !(depth_mm >= between(of_machine[0], of_machine[1], share)) ? 1 : 0;
    }
    point.probability_stable = static_cast<double>(stable) / static_cast<double>(draws);
    return point;
}

}  // namespace lathelier::stability
