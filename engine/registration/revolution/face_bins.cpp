#include "engine/registration/revolution/face_bins.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

/// Which bins noise along the axis makes of a face (README, "Thresholds").
struct FaceBinThresholds {
    double step_sigmas = 3;           ///< difference between neighbouring bins that is a step: 99.7 % of noise is less
    double least_step_slope = 1.5;    ///< dR/dz: a smaller difference is no step, even with little scatter
    double noise_reach_sigmas = 6;    ///< extent of the noise of a face along the axis: ± 3 standard deviations
    double narrowest_land_mm = 0.2;   ///< narrower lands are not expected
    std::size_t most_runs = 2;        ///< runs between two sides that are noise; more are a slope
    double mixed_reach_sigmas = 2.5;  ///< from a face, within which bins hold its points and those of a side
    std::size_t joined_bins = 2;      ///< from a known bin to the next; further apart they have the face between them
};
constexpr FaceBinThresholds faceBinThresholds{};

/// Known bins from `first` to `last` without a step, the unknown ones between included.
struct Run {
    std::size_t first, last;
};

void clearRun(RadiusProfile& profile, const Run& run)
{
    for (std::size_t i = run.first; i <= run.last; ++i) {
        profile.radius_mm[i] = profile.slope[i] = profile.sigma_mm[i] = notANumber;
        profile.points[i] = 0;
    }
}

/// Smallest difference of radii that is a step.
double leastStep_mm(const RadiusProfile& profile, double sigma_mm)
{
    return std::max(faceBinThresholds.step_sigmas * sigma_mm, faceBinThresholds.least_step_slope * profile.step_mm);
}

/// Longest run of bins that noise makes of a face.
double longestRun_mm(double sigma_mm)
{
    return faceBinThresholds.noise_reach_sigmas * sigma_mm + faceBinThresholds.narrowest_land_mm;
}

std::vector<Run> runsOf(const RadiusProfile& profile, double least_step_mm)
{
    std::vector<Run> runs;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double radius = profile.radius_mm[i];
        if (std::isnan(radius)) continue;
        if (!runs.empty() && std::abs(radius - profile.radius_mm[runs.back().last]) <= least_step_mm)
            runs.back().last = i;
        else
            runs.push_back({i, i});
    }
    return runs;
}

/// Unknown bins, in which the face itself lies, part two runs.
bool isGap(const Run& one, const Run& next)
{
    return next.first > one.last + faceBinThresholds.joined_bins;
}

/// Clears the short runs from `begin` to `end` - 1 whose radius lies between those before and after them, unless there
/// are too many of them between two gaps. `most_beside_gap`: so many are noise next to a gap.
void clearShortRuns(RadiusProfile& profile, const std::vector<Run>& runs, std::size_t begin, std::size_t end,
                    std::size_t most_beside_gap)
{
    // Beyond an end of the part the face is inside of all radii beside it.
    const double before = begin > 0 ? profile.radius_mm[runs[begin - 1].last] : 0;
    const double after = end < runs.size() ? profile.radius_mm[runs[end].first] : 0;
    for (std::size_t from = begin; from < end;) {
        std::size_t to = from + 1;
        while (to < end && !isGap(runs[to - 1], runs[to])) ++to;
        const bool beside_gap =
            (from > 0 && isGap(runs[from - 1], runs[from])) || (to < runs.size() && isGap(runs[to - 1], runs[to]));
        if (to - from <= (beside_gap ? most_beside_gap : faceBinThresholds.most_runs))
            for (std::size_t k = from; k < to; ++k) {
                const double radius = profile.radius_mm[runs[k].first];
                if ((radius - before) * (radius - after) < 0) clearRun(profile, runs[k]);
            }
        from = to;
    }
}

}  // namespace

void clearFaceBins(RadiusProfile& profile, double sigma_mm)
{
    const double longest_mm = longestRun_mm(sigma_mm);
    const std::vector<Run> runs = runsOf(profile, leastStep_mm(profile, sigma_mm));
    const double mixed_bins = std::ceil(faceBinThresholds.mixed_reach_sigmas * sigma_mm / profile.step_mm);
    const std::size_t most_beside_gap = std::max(faceBinThresholds.most_runs, static_cast<std::size_t>(mixed_bins));
    const auto isShort = [&](const Run& run) {
        return static_cast<double>(run.last - run.first + 1) * profile.step_mm <= longest_mm;
    };
    for (std::size_t begin = 0; begin < runs.size();) {
        std::size_t end = begin;
        while (end < runs.size() && isShort(runs[end])) ++end;
        const std::size_t count = end - begin;
        if (count > 0 && count < runs.size()) clearShortRuns(profile, runs, begin, end, most_beside_gap);
        begin = std::max(end, begin + 1);
    }
}

void clearRoughFaceBins(std::vector<double>& rough_mm, const RadiusProfile& profile, double sigma_mm)
{
    const double step = leastStep_mm(profile, sigma_mm);
    const std::size_t count = std::min(rough_mm.size(), profile.size());
    double before = 0;  // radius of the last known bin
    for (std::size_t i = 0; i < count;) {
        if (std::isnan(rough_mm[i]) || !std::isnan(profile.radius_mm[i])) {
            if (!std::isnan(profile.radius_mm[i])) before = profile.radius_mm[i];
            ++i;
            continue;
        }
        // Bins between the last rough one and the next known one may be unknown.
        std::size_t end = i;
        for (std::size_t k = i; k < count && std::isnan(profile.radius_mm[k]); ++k)
            if (!std::isnan(rough_mm[k])) end = k + 1;
        std::size_t next = end;
        while (next < profile.size() && std::isnan(profile.radius_mm[next])) ++next;
        const double after = next < profile.size() ? profile.radius_mm[next] : 0;
        const bool is_short = static_cast<double>(end - i) * profile.step_mm <= longestRun_mm(sigma_mm);
        if (is_short && std::abs(after - before) > step)
            std::fill(rough_mm.begin() + static_cast<std::ptrdiff_t>(i),
                      rough_mm.begin() + static_cast<std::ptrdiff_t>(end), notANumber);
        i = end;
    }
}

}  // namespace lathelier::registration
