#include "engine/registration/verdict/meridian_runs.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::registration {

std::vector<SmoothRun> smoothRuns(const TurnedPart& part)
{
    const RadiusProfile& p = part.fit.profile;
    std::vector<SmoothRun> runs;
    const auto lowerEnd = [&](std::size_t bin) { return p.z_start_mm + static_cast<double>(bin) * p.step_mm; };
    const double jump = 8 * part.fit.sigma_mm;
    std::size_t from = 0;
    double start = notANumber;
    const auto finish = [&](std::size_t to, double end) {
        if (to >= from + 3)
            runs.push_back(
                {from, to, std::isnan(start) ? lowerEnd(from) : start, std::isnan(end) ? lowerEnd(to) : end});
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (std::isnan(p.radius_mm[i])) {
            finish(i, notANumber);
            from = i + 1;
            start = notANumber;
            continue;
        }
        if (i == from) continue;
        const double middle = (p.middle_mm(i - 1) + p.middle_mm(i)) / 2;
        const auto edge = std::find_if(part.shoulders.begin(), part.shoulders.end(),
                                       [&](const Shoulder& s) { return std::abs(s.z_mm - middle) <= p.step_mm / 2; });
        const bool turns = i >= 2 && i + 1 < p.size() && std::abs(p.slope[i] - p.slope[i - 1]) > 0.2 &&
                           std::abs(p.slope[i + 1] - p.slope[i - 2]) > 0.2;
        if (edge == part.shoulders.end() && !turns &&
            !(std::abs(p.radius_mm[i] - p.radius_mm[i - 1]) > jump + 3 * p.step_mm))
            continue;
        // A kink or jump without a known shoulder lies somewhere in the bins beside it.
        const bool known = edge != part.shoulders.end();
        finish(i, known ? edge->z_mm : middle - p.step_mm);
        from = i;
        start = known ? edge->z_mm : middle + p.step_mm;
    }
    finish(p.size(), notANumber);
    return runs;
}

std::vector<Interval> automaticZones(const TurnedPart& part, const MeridianLine& line)
{
    constexpr std::size_t margin_bins = 2;  // the scanner's spot smears bins nearer to an edge
    const RadiusProfile& p = part.fit.profile;
    const double longest = (line.zLast_mm() - line.zFirst_mm()) / 8;
    std::vector<Interval> zones;
    for (const SmoothRun& run : smoothRuns(part)) {
        if (run.last < run.first + 2 * margin_bins + 3) continue;
        const double start = p.z_start_mm + static_cast<double>(run.first + margin_bins) * p.step_mm - line.zFirst_mm();
        const double length = static_cast<double>(run.last - run.first - 2 * margin_bins) * p.step_mm;
        const int parts = std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
        for (int k = 0; k < parts; ++k) zones.push_back({start + length * k / parts, start + length * (k + 1) / parts});
    }
    return zones;
}

}  // namespace lathelier::registration
