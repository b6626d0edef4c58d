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
                 least = run.least_mm - sectionLimits.inner_mm - sectionLimits.wall_gap_sigmas * sigma_mm;
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

/// Do nearly all points of a run lie on the shape of another one?
bool isOfShape(const StretchPoints& points, const SectionShape& shape)
{
    double judged = 0, on = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double radius = shape.radiusAt_mm(points.turn[i], points.z_mm[i]);
        if (std::isnan(radius)) continue;
        judged += 1;
        on += std::abs(points.r_mm[i] - radius) < points.onShape_mm() ? 1 : 0;
    }
    return judged > 0 && on > stretchEnds.absorb_share * judged;
}

/// The search for stretches, run by run.
class StretchSearch {
public:
    StretchSearch(const MeridianCloud& cloud, double sigma_mm, const registration::RevolutionFit& fit)
        : cloud_(cloud), sigma_mm_(sigma_mm), fit_(fit)
    {
    }

    /// The longest first: a shorter one beside it may be part of it.
    template <class ShapeOf>
    void addAll(std::vector<SectionRun> runs, const ShapeOf& shapeOfPoints, const Progress& progress)
    {
        std::stable_sort(runs.begin(), runs.end(), [](const SectionRun& a, const SectionRun& b) {
            return a.to_mm - a.from_mm > b.to_mm - b.from_mm;
        });
        for (const SectionRun& run : runs) {
            progress.check();
            const std::optional<StretchPoints> points = pointsOfRun(cloud_, run, sigma_mm_, fit_);
            if (!points || absorb(run, *points)) continue;
            if (const std::optional<FoundShape> found = shapeOfPoints(*points))
                found_.push_back({found->shape, found->mark, run.from_mm, run.to_mm, {}, {}});
        }
    }

    std::vector<NotRoundStretch> stretches()
    {
        for (NotRoundStretch& stretch : found_) placeStretchEnds(cloud_, sigma_mm_, stretch);
        std::sort(found_.begin(), found_.end(),
                  [](const NotRoundStretch& a, const NotRoundStretch& b) { return a.from_mm < b.from_mm; });
        return std::move(found_);
    }

private:
    /// Makes the run part of a stretch beside it whose shape it has.
    bool absorb(const SectionRun& run, const StretchPoints& points)
    {
        for (NotRoundStretch& stretch : found_) {
            const bool is_beside = run.from_mm < stretch.to_mm + sectionLimits.join_mm &&
                                   run.to_mm > stretch.from_mm - sectionLimits.join_mm;
            if (!is_beside || !isOfShape(points, stretch.shape)) continue;
            stretch.from_mm = std::min(stretch.from_mm, run.from_mm);
            stretch.to_mm = std::max(stretch.to_mm, run.to_mm);
            return true;
        }
        return false;
    }

    const MeridianCloud& cloud_;
    double sigma_mm_;
    const registration::RevolutionFit& fit_;
    std::vector<NotRoundStretch> found_;
};

}  // namespace

std::vector<NotRoundStretch> notRoundStretches(const MeridianCloud& cloud, double sigma_mm,
                                               const registration::RevolutionFit& fit, const Progress& progress)
{
    SectionRuns runs = notRoundRuns(cloud, sigma_mm, progress);
    StretchSearch search(cloud, sigma_mm, fit);
    search.addAll(std::move(runs.alike), namedShape, progress);
    search.addAll(
        std::move(runs.winding), [&](const StretchPoints& points) { return helixOf(points, progress); }, progress);
    return search.stretches();
}

}  // namespace lathelier::features
