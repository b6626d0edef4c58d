#include "engine/features/holes/hole_rim.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/units.h"
#include "engine/features/holes/hole_limits.h"

namespace lathelier::features {
namespace {

/// Points of the wall and all rays in one part of a view.
struct Seen {
    double wall = 0, all = 0;
};

/// Distance of a ray from the rim and its direction from the centre as a share of a turn.
struct AboutRim {
    double distance_mm = 0, turn = 0;
    bool on_wall = true;
};

std::vector<AboutRim> aboutRim(const RimView& view, const RimShape& rim)
{
    const double z = (rim.start_mm + rim.end_mm) / 2;
    std::vector<AboutRim> all;
    for (const RimRay& ray : view.rays) {
        const double angle = std::atan2(ray.across_mm - rim.middle_mm(), ray.z_mm - z);
        all.push_back({distanceFrom(rim, ray.z_mm, ray.across_mm).distance_mm, angle / turn_rad + 0.5, ray.on_wall});
    }
    return all;
}

/// A ring about a rim, from one distance to another.
struct RimBand {
    double from_mm = 0, to_mm = 1;
};

std::size_t rimSector(const AboutRim& ray, std::size_t count)
{
    return std::min(count - 1, static_cast<std::size_t>(ray.turn * static_cast<double>(count)));
}

/// Share of each sector of a ring that lies within the wall or face.
std::vector<double> openShares(const RimView& view, const RimShape& rim, const RimBand& ring, std::size_t count)
{
    constexpr int fine = 8;
    std::vector<double> shares(count, 0);
    const double z = (rim.start_mm + rim.end_mm) / 2, half = rim.width_mm() / 2;
    for (std::size_t s = 0; s < count; ++s)
        for (int a = 0; a < fine; ++a)
            for (int k = 0; k < fine; ++k) {
                const double turn = (static_cast<double>(s) + (a + 0.5) / fine) / static_cast<double>(count) - 0.5;
                const double r = half + ring.from_mm + (ring.to_mm - ring.from_mm) * (k + 0.5) / fine;
                if (view.holds(z + r * std::cos(turn * turn_rad), rim.middle_mm() + r * std::sin(turn * turn_rad)))
                    shares[s] += 1.0 / (fine * fine);
            }
    return shares;
}

/// Points of the wall for each mm² of it, in a ring.
double density(const std::vector<AboutRim>& rays, const RimView& view, const RimShape& rim, const RimBand& ring)
{
    double points = 0, open = 0;
    for (const AboutRim& ray : rays)
        points += ray.on_wall && ray.distance_mm > ring.from_mm && ray.distance_mm < ring.to_mm ? 1 : 0;
    for (const double share : openShares(view, rim, ring, holeLimits.sectors))
        open += share / static_cast<double>(holeLimits.sectors);
    const double area = areaWithin_mm2(rim, view, ring.to_mm) - areaWithin_mm2(rim, view, ring.from_mm);
    return points / std::max(1e-9, area * open);
}

/// Is the wall missing inside and seen all around?
bool isHole(const std::vector<AboutRim>& rays, const RimView& view, const RimShape& rim)
{
    const double clear = holeLimits.clear_mm + holeLimits.clear_blurs * std::max(rim.blur_mm, rim.blur_z_mm);
    const RimBand about{clear, clear + holeLimits.ring_mm};
    Seen inside;
    std::vector<Seen> ring(holeLimits.sectors);
    for (const AboutRim& ray : rays) {
        const bool is_about = ray.distance_mm > about.from_mm && ray.distance_mm < about.to_mm;
        if (!is_about && !(ray.distance_mm < -clear)) continue;
        Seen& seen = is_about ? ring[rimSector(ray, ring.size())] : inside;
        seen.all += 1;
        seen.wall += ray.on_wall ? 1 : 0;
    }
    const std::vector<double> open = openShares(view, rim, about, ring.size());
    if (!view.has_misses) {
        const double per_mm2 = density(rays, view, rim, about);
        const double area = areaWithin_mm2(rim, view, about.to_mm) - areaWithin_mm2(rim, view, about.from_mm);
        inside.all = per_mm2 * areaWithin_mm2(rim, view, -clear);
        for (std::size_t s = 0; s < ring.size(); ++s)
            ring[s].all = per_mm2 * area * open[s] / static_cast<double>(ring.size());
    }
    std::size_t judged = 0, hidden = 0;
    for (std::size_t s = 0; s < ring.size(); ++s) {
        if (open[s] < holeLimits.least_open_share) continue;
        ++judged;
        if (ring[s].all < holeLimits.least_ring_rays || ring[s].wall < holeLimits.least_ring_share * ring[s].all)
            ++hidden;
    }
    return inside.all >= holeLimits.least_rays && inside.wall <= holeLimits.most_wall_inside * inside.all &&
           judged >= holeLimits.least_judged && hidden <= holeLimits.most_hidden;
}

/// Is the rim of each sector at the same distance from the centre?
bool isCircle(const std::vector<AboutRim>& rays, const RimView& view, const RimShape& rim)
{
    constexpr double reach = holeLimits.rim_reach_mm;
    std::vector<Seen> sectors(holeLimits.rim_sectors);
    std::vector<double> sums(sectors.size(), 0);
    for (const AboutRim& ray : rays) {
        if (std::abs(ray.distance_mm) > reach) continue;
        const std::size_t s = rimSector(ray, sectors.size());
        sectors[s].all += 1;
        sectors[s].wall += ray.on_wall ? 1 : 0;
        sums[s] += ray.on_wall ? ray.distance_mm : 0;
    }
    const std::vector<double> open = openShares(view, rim, {0, reach}, sectors.size());
    double squares = 0, judged = 0;
    for (std::size_t s = 0; s < sectors.size(); ++s) {
        if (sectors[s].wall < holeLimits.least_ring_rays || open[s] < holeLimits.rim_open_share) continue;
        // The wall begins where the points of an even density from there to `reach` have their mean, or their number.
        const double begin = view.has_misses ? reach - 2 * reach * sectors[s].wall / sectors[s].all
                                             : 2 * sums[s] / sectors[s].wall - reach;
        squares += begin * begin;
        judged += 1;
    }
    if (judged < static_cast<double>(holeLimits.least_rims)) return false;
    const double spacing = 1 / std::sqrt(std::max(1e-9, density(rays, view, rim, {0, reach})));
    return std::sqrt(squares / judged) <=
           holeLimits.rim_rms_mm + holeLimits.rim_share * rim.width_mm() + holeLimits.spacings * spacing;
}

}  // namespace

std::optional<RoundHole> roundHole(const RimView& view, const RimShape& first, const Progress& progress)
{
    const RimShape rough = bestRim(view, first, progress);
    if (rough.width_mm() < holeLimits.least_diameter_mm) return std::nullopt;
    if (rough.start_mm < view.from_mm || rough.end_mm > view.to_mm) return std::nullopt;
    if (view.radius_mm > 0 && rough.width_mm() > 2 * holeLimits.most_radius_share * view.radius_mm) return std::nullopt;
    if (!isHole(aboutRim(view, rough), view, rough)) return std::nullopt;
    const RimFit fit = fitRim(view, rough, progress);
    const std::vector<AboutRim> rays = aboutRim(view, fit.rim);
    if (!isHole(rays, view, fit.rim) || !isCircle(rays, view, fit.rim)) return std::nullopt;
    return RoundHole{(fit.rim.start_mm + fit.rim.end_mm) / 2, fit.rim.middle_mm(), fit.rim.width_mm(),
                     std::hypot(fit.width_sigma_mm, holeLimits.form_mm),
                     std::max(fit.middle_sigma_mm, fit.start_sigma_mm)};
}

}  // namespace lathelier::features
