#include "engine/registration/revolution/face_bins.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

constexpr double stepSigmas = 3;             // difference between neighbouring bins that is a step, in σ
constexpr double leastStepSlope = 1.5;       // dR/dz: a smaller difference is no step, even with little scatter
constexpr double faceNoiseReach_sigmas = 6;  // extent of the noise of a face along the axis, in σ
constexpr double narrowestLand_mm = 0.2;     // narrower lands are not expected
constexpr std::size_t mostRuns = 2;          // runs between two sides
constexpr double mixedReach_sigmas = 2.5;  // distance from a face up to which bins hold its points and those of a side

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
    return std::max(stepSigmas * sigma_mm, leastStepSlope * profile.step_mm);
}

/// Longest run of bins that noise makes of a face.
double longestRun_mm(double sigma_mm)
{
    return faceNoiseReach_sigmas * sigma_mm + narrowestLand_mm;
}

}  // namespace

void clearFaceBins(RadiusProfile& profile, double sigma_mm)
{
    const double step = leastStep_mm(profile, sigma_mm);
    const double reach = longestRun_mm(sigma_mm);
    std::vector<Run> runs;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double radius = profile.radius_mm[i];
        if (std::isnan(radius)) continue;
        if (!runs.empty() && std::abs(radius - profile.radius_mm[runs.back().last]) <= step)
            runs.back().last = i;
        else
            runs.push_back({i, i});
    }
    const std::size_t most_beside_gap =
        std::max(mostRuns, static_cast<std::size_t>(std::ceil(mixedReach_sigmas * sigma_mm / profile.step_mm)));
    const auto isGap = [](const Run& one, const Run& next) { return next.first > one.last + 2; };
    const auto isShort = [&](const Run& run) {
        return static_cast<double>(run.last - run.first + 1) * profile.step_mm <= reach;
    };
    for (std::size_t begin = 0; begin < runs.size();) {
        std::size_t end = begin;
        while (end < runs.size() && isShort(runs[end])) ++end;
        const std::size_t count = end - begin;
        // Beyond an end of the part the face is inside of all radii beside it.
        const double before = begin > 0 ? profile.radius_mm[runs[begin - 1].last] : 0;
        const double after = end < runs.size() ? profile.radius_mm[runs[end].first] : 0;
        if (count > 0 && count < runs.size())
            for (std::size_t from = begin; from < end;) {
                // Unknown bins, in which the face itself lies, part what noise makes of its two sides.
                std::size_t to = from + 1;
                while (to < end && !isGap(runs[to - 1], runs[to])) ++to;
                const bool beside_gap = (from > 0 && isGap(runs[from - 1], runs[from])) ||
                                        (to < runs.size() && isGap(runs[to - 1], runs[to]));
                if (to - from <= (beside_gap ? most_beside_gap : mostRuns))
                    for (std::size_t k = from; k < to; ++k) {
                        const double radius = profile.radius_mm[runs[k].first];
                        if ((radius - before) * (radius - after) < 0) clearRun(profile, runs[k]);
                    }
                from = to;
            }
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
