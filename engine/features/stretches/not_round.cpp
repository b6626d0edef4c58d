#include "engine/features/stretches/not_round.h"

#include <algorithm>
#include <cmath>

#include "engine/features/stretches/eccentric_fit.h"
#include "engine/features/stretches/helix_fit.h"
#include "engine/features/stretches/prism_fit.h"
#include "engine/features/stretches/sections.h"
#include "engine/features/stretches/spline_fit.h"
#include "engine/features/stretches/stretch_ends.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

/// Points of a run without its ends and without those of a bore; nothing where there are few.
std::optional<StretchPoints> pointsOfRun(const MeridianCloud& cloud, const SectionRun& run, double sigma_mm,
                                         const registration::RevolutionFit& fit)
{
    const double margin = (run.to_mm - run.from_mm) / static_cast<double>(2 * stretchProof.z_parts);
    const double from = run.from_mm + margin, to = run.to_mm - margin,
                 least = run.leastRadius_mm() - sectionLimits.inner_mm - sectionLimits.wall_gap_sigmas * sigma_mm;
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]);
        if (z > from && z<to&& static_cast<double>(cloud.r_mm[i])> least) own.push_back(i);
    }
    if (own.size() < stretchProof.least_points) return std::nullopt;
    StretchPoints points;
    const std::size_t used = std::min(own.size(), stretchProof.most_points);
    for (std::size_t k = 0; k < used; ++k) {
        const std::size_t i = own[k * own.size() / used];
        points.z_mm.push_back(static_cast<double>(cloud.z_mm[i]));
        points.r_mm.push_back(static_cast<double>(cloud.r_mm[i]));
        points.turn.push_back(static_cast<double>(cloud.turn[i]));
    }
    points.sigma_mm = sigma_mm;
    const double middle = (from + to) / 2;
    const Eigen::Matrix4d& known = fit.covariance;
    points.axis_sigma_mm =
        std::sqrt(std::max(0.0, (known(0, 0) + known(1, 1) + middle * middle * (known(2, 2) + known(3, 3))) / 2));
    return points;
}

std::optional<FoundShape> namedShape(const StretchPoints& points)
{
    if (auto eccentric = eccentricOf(points)) return eccentric;
    if (auto prism = prismOf(points)) return prism;
    return splineOf(points);
}

}  // namespace

std::vector<NotRoundStretch> notRoundStretches(const MeridianCloud& cloud, double sigma_mm,
                                               const registration::RevolutionFit& fit, const Progress& progress)
{
    std::vector<NotRoundStretch> found;
    const SectionRuns runs = notRoundRuns(cloud, sigma_mm, progress);
    const auto add = [&](const SectionRun& run, const auto& shapeOfRun) {
        progress.check();
        const std::optional<StretchPoints> points = pointsOfRun(cloud, run, sigma_mm, fit);
        const std::optional<FoundShape> shape = points ? shapeOfRun(*points) : std::nullopt;
        if (!shape) return;
        NotRoundStretch stretch{shape->shape, shape->mark, run.from_mm, run.to_mm};
        placeStretchEnds(cloud, sigma_mm, stretch);
        found.push_back(std::move(stretch));
    };
    for (const SectionRun& run : runs.alike) add(run, namedShape);
    for (const SectionRun& run : runs.winding)
        add(run, [&](const StretchPoints& points) { return helixOf(points, progress); });
    std::sort(found.begin(), found.end(),
              [](const NotRoundStretch& a, const NotRoundStretch& b) { return a.from_mm < b.from_mm; });
    return found;
}

}  // namespace lathelier::features
