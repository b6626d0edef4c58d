#include "engine/features/stretches/stretch_ends.h"

#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

/// A point near an end: its distance beyond the end that was known before, and whether it lies on the shape.
struct NearEnd {
    double beyond_mm = 0;
    bool is_on = false, is_below = false;
};

struct ShareOn {
    double count = 0, on = 0;

    void add(bool is_on)
    {
        count += 1;
        on += is_on ? 1 : 0;
    }
    /// Never quite none and all.
    double share() const { return (on + 0.5) / (count + 1); }
};

std::vector<NearEnd> pointsNear(const MeridianCloud& cloud, const NotRoundStretch& stretch, double sigma_mm,
                                double end_mm, double sign, double before_mm)
{
    const double limit = stretchProof.on_sigmas * sigma_mm + stretchProof.on_mm;
    std::vector<NearEnd> near;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double beyond = sign * (static_cast<double>(cloud.z_mm[i]) - end_mm);
        if (beyond < -before_mm || beyond > stretchEnds.extend_mm) continue;
        const double radius =
            stretch.shape.radiusAt_mm(static_cast<double>(cloud.turn[i]), static_cast<double>(cloud.z_mm[i]));
        if (std::isnan(radius)) continue;
        near.push_back({beyond, std::abs(static_cast<double>(cloud.r_mm[i]) - radius) < limit,
                        isBelowRound(stretch.shape, radius, sigma_mm)});
    }
    std::sort(near.begin(), near.end(), [](const NearEnd& a, const NearEnd& b) { return a.beyond_mm < b.beyond_mm; });
    return near;
}

/// How far beyond the known end the shape ends; 0 where the points do not say.
double changeOf(const std::vector<NearEnd>& near)
{
    ShareOn inside, outside;
    std::vector<double> on;
    for (const NearEnd& point : near) {
        if (point.beyond_mm < -stretchEnds.beyond_mm) inside.add(point.is_on);
        if (point.beyond_mm > stretchEnds.beyond_mm && point.beyond_mm < stretchEnds.reach_mm) outside.add(point.is_on);
        if (point.is_on && point.beyond_mm < stretchEnds.reach_mm) on.push_back(point.beyond_mm);
    }
    if (outside.count < static_cast<double>(stretchEnds.least_points))
        return on.empty() ? 0 : lowerQuantileInPlace(on, 1 - stretchEnds.tail_share);
    const double of_on = std::log(inside.share() / outside.share()),
                 of_off = std::log((1 - inside.share()) / (1 - outside.share()));
    if (!(of_on > 0)) return 0;
    double sum = 0, most = 0, place = -stretchEnds.reach_mm;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (near[i].beyond_mm < -stretchEnds.reach_mm) continue;
        if (near[i].beyond_mm > stretchEnds.reach_mm) break;
        sum += near[i].is_on ? of_on : of_off;
        if (sum <= most) continue;
        most = sum;
        place = i + 1 < near.size() ? (near[i].beyond_mm + near[i + 1].beyond_mm) / 2 : near[i].beyond_mm;
    }
    return place;
}

/// How far beyond `from_mm` gaps or faces go on.
double extensionOf(const std::vector<NearEnd>& near, double from_mm)
{
    double reached = from_mm;
    for (double step = from_mm; step < stretchEnds.extend_mm; step += stretchEnds.extend_step_mm) {
        ShareOn below;
        double last = reached;
        for (const NearEnd& point : near) {
            if (!point.is_below || point.beyond_mm < step || point.beyond_mm > step + stretchEnds.extend_step_mm)
                continue;
            below.add(point.is_on);
            if (point.is_on) last = point.beyond_mm;
        }
        if (below.count < 1 || below.on < stretchEnds.extend_share * below.count) break;
        reached = last;
    }
    return reached;
}

}  // namespace

bool isBelowRound(const SectionShape& shape, double radius_mm, double sigma_mm)
{
    return shape.kind != MarkKind::Eccentric &&
           radius_mm < shape.level_mm - stretchEnds.low_sigmas * sigma_mm - stretchEnds.low_mm;
}

void placeStretchEnds(const MeridianCloud& cloud, double sigma_mm, NotRoundStretch& stretch)
{
    const double before_mm = std::max(stretchEnds.reach_mm, (stretch.to_mm - stretch.from_mm) / 3);
    const auto place = [&](double& end_mm, double sign) {
        const std::vector<NearEnd> near = pointsNear(cloud, stretch, sigma_mm, end_mm, sign, before_mm);
        const double change = changeOf(near), extension = extensionOf(near, change), known = end_mm;
        end_mm = known + sign * change;
        return known + sign * extension;
    };
    stretch.mark.z_start_mm = place(stretch.from_mm, -1);
    stretch.mark.z_end_mm = place(stretch.to_mm, 1);
}

}  // namespace lathelier::features
