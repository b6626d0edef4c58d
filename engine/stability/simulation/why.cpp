#include "engine/stability/simulation/why.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/stability/simulation/cut_views.h"

namespace lathelier::stability {
namespace {

/// Receptance at a frequency, linear between two lines; NaN outside.
std::complex<double> at(const Frf& frf, double frequency_hz)
{
    const auto& lines = frf.frequency_hz;
    const auto after = std::lower_bound(lines.begin(), lines.end(), frequency_hz);
    if (after == lines.end() || (after == lines.begin() && *after > frequency_hz)) return {NAN, NAN};
    if (after == lines.begin()) return frf.value.front();
    const auto i = static_cast<std::size_t>(after - lines.begin());
    const double share = (frequency_hz - lines[i - 1]) / (lines[i] - lines[i - 1]);
    return frf.value[i - 1] + share * (frf.value[i] - frf.value[i - 1]);
}

}  // namespace

std::vector<WhyLine> whyOf(const SimulationResult& cut, const LobeResult& lobes, const Frf& frf,
                           const Language& language)
{
    const SimulationParameters& p = cut.parameters;
    const double speed = *p.speed_rpm;
    const auto number = [&](double value, int decimals) { return fixed(value, decimals, language); };
    std::vector<WhyLine> lines;
    lines.push_back({LT_TEXT("Engine", "One revolution later the tool meets the wave that it left."), "T = 60 / N",
                     "60 / " + number(speed, 0) + " = " + number(60000 / speed, 2) + " ms"});
    lines.push_back(
        {LT_TEXT("Engine", "The chip is as thick as the feed and both waves make it; the force follows it."),
         "F = K_r · a · (f + w − x)",
         number(*p.cutting_coefficient_N_mm2, 0) + " · " + number(*p.depth_mm, 3) + " · " + number(p.feed_mm_rev, 3) +
             " = " + number(*p.cutting_coefficient_N_mm2 * *p.depth_mm * p.feed_mm_rev, 1) + " N"});
    const WavePhase phase = phaseOf(cut.frequency_hz, speed, p.feed_mm_rev);
    lines.push_back({LT_TEXT("Engine", "Between two revolutions lie whole waves and a rest, the phase ε."),
                     "60 · f_c / N = k + ε / 360°",
                     "60 · " + number(cut.frequency_hz, 1) + " / " + number(speed, 0) + " = " + number(phase.whole, 0) +
                         " + " + number(phase.phase_deg, 0) + "° / 360°"});
    if (std::isfinite(phase.period_mm))
        lines.push_back({LT_TEXT("Engine", "Its rest slants the marks on the surface and repeats them along the axis."),
                         "f / |ν|",
                         number(p.feed_mm_rev, 3) + " / " + number(std::abs(phase.fraction), 3) + " = " +
                             number(phase.period_mm, 3) + " mm"});
    lines.push_back({cut.growth_per_revolution > 1
                         ? LT_TEXT("Engine", "The wave comes back larger after every revolution: it grows to chatter.")
                         : LT_TEXT("Engine", "The wave comes back smaller after every revolution: it dies out."),
                     "e^(Re(s) · T)", number(cut.growth_per_revolution, 3)});
    const PointStability work = pointStabilityAt(lobes, speed, *p.depth_mm);
    if (!std::isfinite(work.limit_mm) || !std::isfinite(work.frequency_hz) || lobes.isRelative()) return lines;
    const std::complex<double> g = p.direction_factor * at(frf, work.frequency_hz);
    if (!std::isfinite(g.real())) return lines;
    if (!p.process_damping_N_mm)
        lines.push_back(
            {LT_TEXT("Engine", "At this speed the limit follows from the real part of the receptance there."),
             "a_lim = −1 / (2 · K_r · Re G)",
             "−1 / (2 · " + number(*p.cutting_coefficient_N_mm2, 0) + " · " + number(1e6 * g.real(), 2) +
                 "e-6 mm/N) = " + number(work.limit_mm, 3) + " mm"});
    const WavePhase limit = phaseOf(work.frequency_hz, speed, p.feed_mm_rev);
    lines.push_back({LT_TEXT("Engine", "A lobe ties speed and frequency by whole waves and phase."),
                     "N = 60 · f / (k + ε / 360°)",
                     "60 · " + number(work.frequency_hz, 1) + " / (" + number(limit.whole, 0) + " + " +
                         number(limit.phase_deg / 360, 3) + ") = " + number(speed, 0)});
    if (limit.whole > 0)
        lines.push_back({LT_TEXT("Engine", "The published relation leaves the phase out and moves every lobe."),
                         "N = 60 · f / k",
                         "60 · " + number(work.frequency_hz, 1) + " / " + number(limit.whole, 0) + " = " +
                             number(60 * work.frequency_hz / limit.whole, 0)});
    return lines;
}

}  // namespace lathelier::stability
