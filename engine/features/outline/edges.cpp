#include "engine/features/outline/edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/features/outline/outline_limits.h"
#include "engine/features/walls/grid_search.h"

namespace lathelier::features {
namespace {

using registration::Ray;

constexpr std::size_t endSectors = 24;  // of the circle: the last hits are compared between them

std::size_t firstRayAt(const std::vector<Ray>& rays, double height)
{
    const auto isBelow = [](const Ray& ray, double h) { return ray.height < h; };
    return static_cast<std::size_t>(std::lower_bound(rays.begin(), rays.end(), height, isBelow) - rays.begin());
}

/// Sum of log P over the rays, which are in order of height.
double logLikelihood(const std::vector<Ray>& rays, const std::vector<std::size_t>& hits_before, double place,
                     double width)
{
    constexpr double p_hit = edgeLimits.hit_probability;
    const std::size_t low = firstRayAt(rays, place - width / 2), high = firstRayAt(rays, place + width / 2);
    const double right = std::log(p_hit), wrong = std::log(1 - p_hit);
    const auto hits = [&](std::size_t from, std::size_t to) {
        return static_cast<double>(hits_before[to] - hits_before[from]);
    };
    const double below_hits = hits(0, low), above_hits = hits(high, rays.size());
    double sum = below_hits * wrong + (static_cast<double>(low) - below_hits) * right + above_hits * right +
                 (static_cast<double>(rays.size() - high) - above_hits) * wrong;
    for (std::size_t i = low; i < high; ++i) {
        const double p = std::clamp((rays[i].height - place) / width + 0.5, 1 - p_hit, p_hit);
        sum += std::log(rays[i].hit ? p : 1 - p);
    }
    return sum;
}

/// The place with the fewest hits below it and misses above it.
double fewestContradictions(const std::vector<Ray>& rays, const std::vector<std::size_t>& hits_before)
{
    const std::size_t n = rays.size(), all_hits = hits_before.back();
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i <= n; ++i) {
        const double wrong =
            static_cast<double>(hits_before[i]) + static_cast<double>((n - i) - (all_hits - hits_before[i]));
        if (!(wrong < least)) continue;
        least = wrong;
        best = i;
    }
    if (best == 0) return rays.front().height;
    return best == n ? rays.back().height : (rays[best - 1].height + rays[best].height) / 2;
}

/// Largest distance of neighbouring heights beside a place.
double gapBeside(const std::vector<Ray>& rays, double place)
{
    const auto near = rays.begin() + static_cast<std::ptrdiff_t>(firstRayAt(rays, place));
    double gap = 0;
    for (auto ray = near - std::min(edgeLimits.gap_rays, near - rays.begin());
         ray + 1 < rays.end() && ray < near + edgeLimits.gap_rays; ++ray)
        gap = std::max(gap, (ray + 1)->height - ray->height);
    return gap;
}

/// A point on the wall at the end of a run; heights grow toward the end, from its estimated place.
struct EndHit {
    double height;
    std::size_t sector;
};

/// Search for the end of the hits on the wall of a run.
class EndSearch {
public:
    EndSearch(const MeridianCloud& cloud, const Model& model, const Run& run, bool start)
        : model_(model),
          run_(run),
          start_(start),
          sign_(start ? -1 : 1),
          guess_mm_(start ? run.nodes_mm.front() : run.nodes_mm.back()),
          depth_mm_(std::min(edgeLimits.end_depth_mm,
                             edgeLimits.end_depth_share * (run.nodes_mm.back() - run.nodes_mm.front())))
    {
        collectHits(cloud);
    }

    std::optional<PlanePlace> find()
    {
        if (hits_.size() < edgeLimits.least_end_hits || !findWholeSectors()) return std::nullopt;
        std::vector<double> used;
        for (const EndHit& hit : hits_)
            if (whole_[hit.sector]) used.push_back(hit.height);
        if (used.size() < edgeLimits.least_whole_hits) return std::nullopt;
        return placeOfRamp(used);
    }

private:
    void collectHits(const MeridianCloud& cloud)
    {
        const Element& last = start_ ? run_.elements.front() : run_.elements.back();
        const double end_node = start_ ? run_.nodes_mm[1] : run_.nodes_mm[run_.nodes_mm.size() - 2];
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
            const double z = static_cast<double>(cloud.z_mm[i]);
            const double height = (z - guess_mm_) * sign_;
            if (height < -depth_mm_ || height > edgeLimits.end_beyond_mm) continue;
            const double at = std::clamp(z, run_.nodes_mm.front(), run_.nodes_mm.back());
            // Beyond the estimated end the last element is extrapolated.
            const double model_r = (z - end_node) * sign_ > 0 ? last.radiusAt_mm(z) : radiusAt_mm(run_, at);
            const double slope = std::abs(last.slopeAt(at));
            if (std::abs(static_cast<double>(cloud.r_mm[i]) - model_r) >
                edgeLimits.end_wall_sigmas * model_.sigma_mm +
                    0.5 * model_.spot_mm * std::min(slope, edgeLimits.steepest_end_slope))
                continue;
            const auto sector = static_cast<std::size_t>(cloud.turn[i] * static_cast<float>(endSectors));
            hits_.push_back({height, std::min(endSectors - 1, sector)});
        }
        std::sort(hits_.begin(), hits_.end(), [](const EndHit& a, const EndHit& b) { return a.height < b.height; });
    }

    /// Sectors in which the wall is whole: with the usual number of hits, the last ones near the median of the last.
    bool findWholeSectors()
    {
        std::array<std::vector<double>, endSectors> heights;
        for (const EndHit& hit : hits_) heights[hit.sector].push_back(hit.height);
        std::vector<double> counts, lasts;
        for (std::size_t s = 0; s < endSectors; ++s) {
            const std::size_t n = heights[s].size();
            counts.push_back(static_cast<double>(n));
            last_[s] = -depth_mm_;
            if (n <= edgeLimits.last_hits) continue;
            last_[s] = heights[s][n - edgeLimits.last_hits];
            lasts.push_back(last_[s]);
        }
        if (lasts.size() < edgeLimits.least_end_sectors) return false;
        const double usual = quantileInPlace(counts, edgeLimits.usual_hits_share);
        common_mm_ = upperMedianInPlace(lasts);
        for (std::size_t s = 0; s < endSectors; ++s)
            whole_[s] = static_cast<double>(heights[s].size()) > edgeLimits.whole_hits_share * usual &&
                        std::abs(last_[s] - common_mm_) < edgeLimits.whole_reach_mm;
        return true;
    }

    /// The end of a Poisson process of constant density; `used`: the heights, in order.
    PlanePlace placeOfRamp(const std::vector<double>& used) const
    {
        // Density from the stretch before the ramp.
        const double from = -depth_mm_, to = common_mm_ - edgeLimits.ramp_margin_mm;
        const auto count =
            std::lower_bound(used.begin(), used.end(), to) - std::lower_bound(used.begin(), used.end(), from);
        const double density = static_cast<double>(count) / std::max(edgeLimits.least_density_length_mm, to - from);
        const double width = model_.spot_mm > 0 ? model_.spot_mm : edgeLimits.assumed_spot_mm;
        const auto log_likelihood = [&](double place) {
            const auto ramp = std::lower_bound(used.begin(), used.end(), place - width / 2);
            double sum = -density * place;
            for (auto h = ramp; h != used.end(); ++h)
                sum += std::log(std::clamp(0.5 - (*h - place) / width, edgeLimits.least_ramp_density, 1.0));
            return sum;
        };
        const double place =
            gridMaximum(log_likelihood, common_mm_, edgeLimits.end_step_mm, edgeLimits.end_rounds, edgeLimits.end_steps)
                .place;
        double gap = 0;
        const auto near = std::lower_bound(used.begin(), used.end(), place - width);
        for (auto h = near - std::min(edgeLimits.gap_hits, near - used.begin()); h + 1 < used.end() && h < near; ++h)
            gap = std::max(gap, *(h + 1) - *h);
        // The density is that of the wall before; the scatter over the sectors includes the effect of regular rows.
        return {guess_mm_ + sign_ * place, std::sqrt(width / (6 * density) + gap * gap / 12 + edgeLimits.end_floor_mm2),
                width};
    }

    const Model& model_;
    const Run& run_;
    bool start_;
    double sign_, guess_mm_, depth_mm_;
    std::vector<EndHit> hits_;               ///< in order of height
    double common_mm_ = 0;                   ///< median height of the last hits
    std::array<double, endSectors> last_{};  ///< height of the last hit of each sector
    std::array<bool, endSectors> whole_{};
};

}  // namespace

std::optional<PlanePlace> placeOf(const registration::EdgeRays& edge)
{
    const std::vector<Ray>& rays = edge.rays;
    std::vector<std::size_t> hits(rays.size() + 1, 0);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i + 1] = hits[i] + (rays[i].hit ? 1 : 0);
    const std::size_t all_hits = hits.back();
    if (all_hits < edgeLimits.least_rays || rays.size() - all_hits < edgeLimits.least_rays) return std::nullopt;
    const double start = fewestContradictions(rays, hits);
    GridMaximum best{start, -std::numeric_limits<double>::infinity()};
    double width = edgeLimits.widths_mm[0];
    for (const double w : edgeLimits.widths_mm) {
        const auto value = [&](double place) { return logLikelihood(rays, hits, place, w); };
        const GridMaximum found =
            gridMaximum(value, start, edgeLimits.ray_step_mm, edgeLimits.ray_rounds, edgeLimits.ray_steps);
        if (!(found.value > best.value)) continue;
        best = found;
        width = w;
    }
    const double place = best.place, gap = gapBeside(rays, place);
    const double reach = std::max(edgeLimits.density_reach_mm, width);
    const std::size_t count = firstRayAt(rays, place + reach) - firstRayAt(rays, place - reach);
    const double density = std::max(1.0, static_cast<double>(count)) / (2 * reach);
    PlanePlace found;
    found.z_mm = place * edge.edge.sign;
    found.spot_mm = width;
    found.sigma_mm = std::sqrt(width / (6 * density) + gap * gap / 12 + edgeLimits.place_floor_mm2 +
                               edge.lean_sigma_mm * edge.lean_sigma_mm);
    return found;
}

std::optional<PlanePlace> seenFace(const MeridianCloud& cloud, double z_mm, double inner_mm, double outer_mm,
                                   double sigma_mm, double least_per_mm2)
{
    const EdgeLimits& limits = edgeLimits;
    sigma_mm = std::max(sigma_mm, limits.least_noise_mm);
    const double margin = limits.face_margin_sigmas * sigma_mm + limits.face_margin_mm,
                 reach = limits.face_reach_sigmas * sigma_mm + limits.face_reach_mm;
    const double low = inner_mm + (inner_mm > 0 ? margin : 0), high = outer_mm - margin;
    if (!(high > low)) return std::nullopt;
    std::vector<double> heights;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        if (std::abs(z - z_mm) < reach && r > low && r < high) heights.push_back(z);
    }
    const double area = std::numbers::pi * (high * high - low * low);
    if (heights.size() < limits.least_face_points || static_cast<double>(heights.size()) < least_per_mm2 * area)
        return std::nullopt;
    for (int round = 0; round < limits.face_rounds; ++round) {
        const double middle = upperMedianInPlace(heights);
        std::erase_if(heights, [&](double z) { return std::abs(z - middle) > limits.face_outlier_sigmas * sigma_mm; });
        if (heights.size() < limits.least_kept_face_points) return std::nullopt;
    }
    double sum = 0, squares = 0;
    for (const double z : heights) sum += z - z_mm;
    const double n = static_cast<double>(heights.size()), mean = sum / n;
    for (const double z : heights) squares += (z - z_mm - mean) * (z - z_mm - mean);
    if (std::sqrt(squares / n) > limits.largest_face_scatter_sigmas * sigma_mm) return std::nullopt;
    return PlanePlace{z_mm + mean, std::sqrt(squares / n / n + limits.face_floor_mm2), 0};
}

std::optional<EndPlace> endOf(const MeridianCloud& cloud, const Model& model, const Run& run, bool start,
                              double loss_mm)
{
    const auto place = EndSearch(cloud, model, run, start).find();
    if (!place) return std::nullopt;
    EndPlace found{*place};
    found.place.sigma_mm = std::hypot(place->sigma_mm, loss_mm / std::numbers::sqrt2);
    found.from_mm = place->z_mm - 2 * found.place.sigma_mm;
    found.to_mm = place->z_mm + 2 * found.place.sigma_mm;
    return found;
}

}  // namespace lathelier::features
