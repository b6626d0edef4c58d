#include "engine/stability/lobe_uncertainty.h"

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/stability/envelope.h"

namespace lathelier::stability {
namespace {

constexpr std::uint64_t draws = 1000;
constexpr double widest = 1.5;  ///< bound of the sampled frequency factor

/// A Monte Carlo sample: scales the frequencies of the boundary by `frequency` and the limits by `depth`.
struct Draw {
    double frequency = 1;
    double depth = 1;
};

std::vector<Draw> drawn(const LobeParameters& p)
{
    std::vector<Draw> result;
    for (std::uint64_t number = 0; number < draws; ++number) {
        const auto factor = [&](std::uint64_t stream, double percent) {
            return std::clamp(1 + percent / 100 * randomNormal(1, stream, number), 1 / widest, widest);
        };
        const double coefficient = p.cutting_coefficient_N_mm2 ? factor(3, p.uncertainty_coefficient_percent) : 1;
        result.push_back({factor(1, p.uncertainty_frequency_percent),
                          1 / (factor(2, p.uncertainty_compliance_percent) * coefficient)});
    }
    return result;
}

}  // namespace

bool isUncertain(const LobeParameters& p)
{
    return p.uncertainty_frequency_percent > 0 || p.uncertainty_compliance_percent > 0 ||
           (p.cutting_coefficient_N_mm2 && p.uncertainty_coefficient_percent > 0);
}

LobeBand bandOf(const LobeParameters& p, const LobeLimit& limit, const LimitOver& limitOver, const Progress& progress)
{
    const Interval wide{limit.speed_rpm.front() / widest, limit.speed_rpm.back() * widest};
    const std::vector<Draw> machines = drawn(p);
    LobeBand band;
    band.whole = limitOver(wide, 2 * p.points);
    std::vector<double> depths;
    for (std::size_t i = 0; i < limit.speed_rpm.size(); ++i) {
        if (i % 64 == 0) progress.report(static_cast<double>(i) / static_cast<double>(limit.speed_rpm.size()));
        depths.clear();
        for (const Draw& draw : machines) {
            const double depth = draw.depth * depthAt(band.whole, limit.speed_rpm[i] / draw.frequency);
            depths.push_back(std::isnan(depth) ? HUGE_VAL : depth);
        }
        const auto finite = [](double depth) { return std::isfinite(depth) ? depth : notANumber; };
        band.low_mm.push_back(finite(quantileInPlace(depths, 0.025)));
        band.high_mm.push_back(finite(quantileInPlace(depths, 0.975)));
    }
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
    int stable = 0;
    for (const Draw& draw : drawn(result.parameters)) {
        stable += !(depth_mm >= draw.depth * depthAt(result.band->whole, speed_rpm / draw.frequency));
    }
    point.probability_stable = static_cast<double>(stable) / static_cast<double>(draws);
    return point;
}

}  // namespace lathelier::stability
