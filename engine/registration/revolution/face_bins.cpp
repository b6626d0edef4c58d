#include "engine/registration/revolution/face_bins.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::registration {
namespace {

constexpr double kStep = 3;          // scatters between neighbouring bins: more is a step
constexpr double kSlope = 1.5;       // dR/dz: less is no step, however little the points scatter
constexpr double kReach = 6;         // scatters that the noise of a face reaches over
constexpr double kLand_mm = 0.2;     // no part has narrower lands
constexpr std::size_t mostRuns = 2;  // runs between two sides

struct Run {
    std::size_t first, last;
};

void forget(RadiusProfile& profile, const Run& run)
{
    for (std::size_t i = run.first; i <= run.last; ++i) {
        profile.radius_mm[i] = profile.slope[i] = profile.sigma_mm[i] = notANumber;
        profile.points[i] = 0;
    }
}

}  // namespace

void forgetFaceBins(RadiusProfile& profile, double sigma_mm)
{
    const double step = std::max(kStep * sigma_mm, kSlope * profile.step_mm);
    const double reach = kReach * sigma_mm + kLand_mm;
    std::vector<Run> runs;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double radius = profile.radius_mm[i];
        if (std::isnan(radius)) continue;
        if (!runs.empty() && std::abs(radius - profile.radius_mm[runs.back().last]) <= step)
            runs.back().last = i;
        else
            runs.push_back({i, i});
    }
    const auto isShort = [&](const Run& run) {
        return static_cast<double>(run.last - run.first + 1) * profile.step_mm <= reach;
    };
    for (std::size_t begin = 0; begin < runs.size();) {
        std::size_t end = begin;
        while (end < runs.size() && isShort(runs[end])) ++end;
        const std::size_t count = end - begin;
        if (count > 0 && count <= mostRuns && count < runs.size()) {
            // Beyond an end of the part the face is inside of all radii beside it.
            const double before = begin > 0 ? profile.radius_mm[runs[begin - 1].last] : 0;
            const double after = end < runs.size() ? profile.radius_mm[runs[end].first] : 0;
            for (std::size_t k = begin; k < end; ++k) {
                const double radius = profile.radius_mm[runs[k].first];
                if ((radius - before) * (radius - after) < 0) forget(profile, runs[k]);
            }
        }
        begin = std::max(end, begin + 1);
    }
}

}  // namespace lathelier::registration
