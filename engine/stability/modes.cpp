#include "engine/stability/modes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "engine/core/units.h"
#include "engine/core/unusual.h"

namespace lathelier::stability {
namespace {

constexpr double belowLowest = 0.1;  ///< first line over the lowest natural frequency
constexpr double aboveHighest = 5;   ///< last line over the highest natural frequency, at least

}  // namespace

const std::vector<Field<Mode>>& fieldsOf(const Mode*)
{
    static const std::vector<Field<Mode>> all{
        field("frequency_hz", &Mode::frequency_hz, {1e-3, 1e6},
              Label{LT_TEXT("Engine", "Natural frequency"), LT_TEXT("Engine", "Undamped."), unit::hz, false, true}),
        field("damping_ratio", &Mode::damping_ratio, {1e-6, 1},
              Label{LT_TEXT("Engine", "Damping ratio"), LT_TEXT("Engine", "ζ, of critical damping."), {}, false, true}),
        field("stiffness_N_mm", &Mode::stiffness_N_mm, {1e-6, 1e12},
              Label{LT_TEXT("Engine", "Modal stiffness"), LT_TEXT("Engine", "Force over displacement at rest."),
                    unit::N_mm, false, true})};
    return all;
}

std::vector<double> linesAround(const std::vector<Mode>& modes, const Interval& range_hz, const LineDensity& density)
{
    std::vector<double> lines;
    for (double f = range_hz.from; f < range_hz.to; f *= density.ratio) lines.push_back(f);
    lines.push_back(range_hz.to);
    const double highest = highestFrequency(modes);
    for (const Mode& mode : modes) {
        if (!mode.isResonance() && highest != mode.frequency_hz) continue;
        const double step = mode.damping_ratio * mode.frequency_hz / density.per_width;
        const int count = static_cast<int>(density.widths_around * density.per_width);
        for (int i = -count; i <= count; ++i)
            if (const double f = mode.frequency_hz + i * step; f > range_hz.from && f < range_hz.to) lines.push_back(f);
    }
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

void noteUnusualModes(const std::vector<Mode>& modes, Notes& notes)
{
    for (const Mode& mode : modes)
        noteUnusual(mode, {{"damping_ratio", {1e-4, 0.4}}, {"stiffness_N_mm", {10, 2e6}}}, notes);
}

Mode complianceMode(double compliance_mm_N)
{
    return {std::numeric_limits<double>::infinity(), 1, 1 / compliance_mm_N};
}

std::string keyOf(const std::vector<Mode>& modes)
{
    std::string key;
    for (const Mode& mode : modes)
        key += fmt::format("{} {} {} {};", mode.frequency_hz, mode.damping_ratio, mode.stiffness_N_mm, mode.lead);
    return key;
}

double highestFrequency(std::span<const Mode> modes)
{
    double resonance = 0, any = 0;
    for (const Mode& mode : modes) {
        if (mode.isResonance()) resonance = std::max(resonance, mode.frequency_hz);
        if (mode.hasMass()) any = std::max(any, mode.frequency_hz);
    }
    return resonance > 0 ? resonance : any;
}

std::complex<double> receptanceOf(const std::vector<Mode>& modes, double frequency_hz)
{
    std::complex<double> sum = 0;
    for (const Mode& mode : modes) {
        const double r = frequency_hz / mode.frequency_hz;
        sum += std::complex<double>(1, mode.lead * r) /
               (mode.stiffness_N_mm * std::complex<double>(1 - r * r, 2 * mode.damping_ratio * r));
    }
    return sum;
}

Frf frfOf(const std::vector<Mode>& modes, double highest_speed_rpm)
{
    Frf frf;
    const double highest = highestFrequency(modes);
    if (!(highest > 0)) return frf;
    double lowest = highest;
    for (const Mode& mode : modes)
        if (mode.isResonance()) lowest = std::min(lowest, mode.frequency_hz);
    // The lobe k = 0 carries frequencies up to N/60.
    const double end = std::max(aboveHighest * highest, 1.1 * highest_speed_rpm / 60);
    frf.frequency_hz = linesAround(modes, {belowLowest * lowest, end});
    for (const double f : frf.frequency_hz) frf.value.push_back(receptanceOf(modes, f));
    return frf;
}

}  // namespace lathelier::stability
