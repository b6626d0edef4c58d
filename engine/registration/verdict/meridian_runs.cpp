#include "engine/registration/verdict/meridian_runs.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

/// Jumps, kinks and zones of a meridian (registration/README.md, "Thresholds").
struct MeridianRunThresholds {
    std::size_t least_bins = 3;        ///< of a run
    double jump_sigmas = 8;            ///< of the scatter: a larger change of the radius from bin to bin is a jump,
    double jump_slope = 3;             ///< when it is larger than this slope makes it as well
    double kink = 0.2;                 ///< change of dR/dz from one bin to the next, and over three of them
    std::size_t zone_margin_bins = 2;  ///< the scanner's spot smears bins nearer to an edge
    std::size_t least_zone_bins = 3;   ///< of an automatic zone
    double zones_per_part = 8;         ///< an automatic zone is no longer than an eighth of the part
    double zone_rounding = 1e-9;       ///< of a zone's length: no further zone for a longer stretch
};
constexpr MeridianRunThresholds runThresholds{};

}  // namespace

std::vector<SmoothRun> smoothRuns(const TurnedPart& part)
{
    const RadiusProfile& p = part.fit.profile;
    std::vector<SmoothRun> runs;
    const auto lowerEnd = [&](std::size_t bin) { return p.z_start_mm + static_cast<double>(bin) * p.step_mm; };
    const double jump = runThresholds.jump_sigmas * part.fit.sigma_mm + runThresholds.jump_slope * p.step_mm;
    std::size_t from = 0;
    double start = notANumber;
    const auto finish = [&](std::size_t to, double end) {
        if (to >= from + runThresholds.least_bins)
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
        const bool turns = i >= 2 && i + 1 < p.size() && std::abs(p.slope[i] - p.slope[i - 1]) > runThresholds.kink &&
                           std::abs(p.slope[i + 1] - p.slope[i - 2]) > runThresholds.kink;
        if (edge == part.shoulders.end() && !turns && !(std::abs(p.radius_mm[i] - p.radius_mm[i - 1]) > jump)) continue;
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
    constexpr std::size_t margin_bins = runThresholds.zone_margin_bins;
    const RadiusProfile& p = part.fit.profile;
    const double longest = (line.zLast_mm() - line.zFirst_mm()) / runThresholds.zones_per_part;
    std::vector<Interval> zones;
    for (const SmoothRun& run : smoothRuns(part)) {
        if (run.last < run.first + 2 * margin_bins + runThresholds.least_zone_bins) continue;
        const double start = p.z_start_mm + static_cast<double>(run.first + margin_bins) * p.step_mm - line.zFirst_mm();
        const double length = static_cast<double>(run.last - run.first - 2 * margin_bins) * p.step_mm;
        const int parts = std::max(1, static_cast<int>(std::ceil(length / longest - runThresholds.zone_rounding)));
        for (int k = 0; k < parts; ++k) zones.push_back({start + length * k / parts, start + length * (k + 1) / parts});
    }
    return zones;
}

}  // namespace lathelier::registration
