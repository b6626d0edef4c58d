#include "engine/features/marks/rim_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/random.h"

namespace lathelier::features {
namespace {

/// Limits of the fit; chosen on scans with known truth.
struct RimLimits {
    double coarse_reach_mm = 1.5, reach_mm = 0.7;  ///< rays further from the rim say nothing of its place
    int coarse_rounds = 6;                         ///< each with the rays about the rim before
    double coarse_blur_mm = 0.15, first_blur_mm = 0.04;
    double least_blur_mm = 0.004, most_blur_mm = 0.15;  ///< below the first, rays on one side only say nothing of it
    double stray_share = 0.003;                         ///< least share of rays that tell of another surface
    double most_stray_share = 0.4;                      ///< of rays that are lost outside
    std::array<double, 6> steps_mm{0.4, 0.2, 0.1, 0.05, 0.02, 0.008};  ///< of the search
    int search_rounds = 12;                                            ///< for each step
    double least_half_mm = 0.5;                                        ///< of a rim
    std::uint64_t warm_up = 160, samples = 280;                        ///< sweeps over the parameters
    std::uint64_t adapted = 40;                                        ///< sweeps after which steps are adapted
    std::size_t strips = 32;                                           ///< across, of an area
};
constexpr RimLimits rimLimits{};

constexpr std::size_t blurParameters = 2;
constexpr std::size_t mostParameters = 4 + blurParameters;

/// A rim as numbers to vary: circle z, across, radius; slot start, end, low, high; logarithms of the blurs behind.
struct RimNumbers {
    RimShape like;
    std::array<double, mostParameters> value{};

    std::size_t places() const { return like.kind == RimKind::Circle ? 3 : 4; }
    std::size_t count() const { return places() + blurParameters; }

    explicit RimNumbers(const RimShape& rim) : like(rim)
    {
        if (rim.kind == RimKind::Circle)
            value = {(rim.start_mm + rim.end_mm) / 2, rim.middle_mm(), rim.width_mm() / 2};
        else
            value = {rim.start_mm, rim.end_mm, rim.low_mm, rim.high_mm};
        value[places()] = std::log(rim.blur_z_mm);
        value[places() + 1] = std::log(rim.blur_mm);
    }

    RimShape shape() const
    {
        RimShape rim = like;
        if (rim.kind == RimKind::Circle) {
            rim = circleRim(value[0], value[1], value[2]);
        } else {
            rim.start_mm = value[0];
            rim.end_mm = value[1];
            rim.low_mm = value[2];
            rim.high_mm = value[3];
        }
        rim.blur_z_mm = std::exp(value[places()]);
        rim.blur_mm = std::exp(value[places() + 1]);
        return rim;
    }
};

bool isPossible(const RimShape& rim)
{
    const auto holds = [](double blur) { return blur >= rimLimits.least_blur_mm && blur <= rimLimits.most_blur_mm; };
    const double half = rim.width_mm() / 2;
    if (!(half >= rimLimits.least_half_mm) || !holds(rim.blur_mm) || !holds(rim.blur_z_mm)) return false;
    const double ends = (rim.round_start ? half : 0) + (rim.round_end ? half : 0);
    return rim.kind == RimKind::Circle || rim.end_mm - rim.start_mm >= ends;
}

/// Rays near a rim, and what those further away say of lost and stray ones.
class RimLikelihood {
public:
    RimLikelihood(const RimView& view, const RimShape& about, double reach_mm) : view_(view)
    {
        double outside = 0, lost = 0;
        for (const RimRay& ray : view.rays) {
            const double distance = distanceFrom(about, ray.z_mm, ray.across_mm).distance_mm;
            if (std::abs(distance) < reach_mm) {
                near_.push_back(ray);
            } else if (distance > 0) {
                outside += 1;
                lost += ray.on_wall ? 0 : 1;
            }
        }
        lost_ = std::clamp((lost + 1) / (outside + 2), rimLimits.stray_share, rimLimits.most_stray_share);
        if (!view.has_misses) area_mm2_ = areaWithin_mm2(about, view, reach_mm);
    }

    double at(const RimShape& rim) const
    {
        if (!isPossible(rim)) return -std::numeric_limits<double>::infinity();
        double sum = 0;
        const double whole = 1 - lost_ - rimLimits.stray_share;
        for (const RimRay& ray : near_) {
            const RimDistance from = distanceFrom(rim, ray.z_mm, ray.across_mm);
            const double on = rimLimits.stray_share + whole / (1 + std::exp(-from.distance_mm / from.blur_mm));
            sum += std::log(ray.on_wall ? on : 1 - on);
        }
        if (view_.has_misses) return sum;
        const double left = area_mm2_ - areaWithin_mm2(rim, view_, 0);
        return left > 0 ? sum - static_cast<double>(near_.size()) * std::log(left)
                        : -std::numeric_limits<double>::infinity();
    }

private:
    const RimView& view_;
    std::vector<RimRay> near_;
    double lost_ = 0;      ///< share of rays that hit nothing outside
    double area_mm2_ = 0;  ///< of the near places
};

/// Pattern search with ever smaller steps along the parameters [0, count).
void climb(const RimLikelihood& likelihood, std::size_t count, RimNumbers& at, const Progress& progress)
{
    double best = likelihood.at(at.shape());
    for (const double step : rimLimits.steps_mm)
        for (int round = 0; round < rimLimits.search_rounds; ++round) {
            progress.check();
            const double before = best;
            for (std::size_t k = 0; k < count; ++k)
                for (const double sign : {-1.0, 1.0}) {
                    RimNumbers next = at;
                    // Logarithms of the blur take steps ten times as large.
                    next.value[k] += sign * step * (k < at.places() ? 1 : 10);
                    const double found = likelihood.at(next.shape());
                    if (!(found > best)) continue;
                    best = found;
                    at = next;
                }
            if (!(best > before)) break;
        }
}

/// Places and widths of strips across, as shares of half the width. They are equal in the angle of a circle: its edge
/// is as well resolved as its middle.
struct Strip {
    double place = 0, width = 0;
};

const std::array<Strip, rimLimits.strips>& strips()
{
    static const auto all = [] {
        std::array<Strip, rimLimits.strips> made;
        const double step = std::numbers::pi / static_cast<double>(rimLimits.strips);
        for (std::size_t i = 0; i < made.size(); ++i) {
            const double angle = (static_cast<double>(i) + 0.5) * step - std::numbers::pi / 2;
            made[i] = {std::sin(angle), std::cos(angle) * step};
        }
        return made;
    }();
    return all;
}

/// Sums of a quantity over the samples.
struct Moments {
    double sum = 0, squares = 0, count = 0;

    void add(double x)
    {
        sum += x;
        squares += x * x;
        count += 1;
    }
    double mean() const { return sum / count; }
    double sigma() const { return std::sqrt(std::max(0.0, squares / count - mean() * mean())); }
};

}  // namespace

RimShape circleRim(double z_mm, double across_mm, double radius_mm)
{
    RimShape rim;
    rim.low_mm = across_mm - radius_mm;
    rim.high_mm = across_mm + radius_mm;
    rim.start_mm = z_mm - radius_mm;
    rim.end_mm = z_mm + radius_mm;
    return rim;
}

RimDistance distanceFrom(const RimShape& rim, double z_mm, double across_mm)
{
    const double half = rim.width_mm() / 2, aside = std::abs(across_mm - rim.middle_mm());
    const double first = rim.start_mm + (rim.round_start ? half : 0), last = rim.end_mm - (rim.round_end ? half : 0);
    const bool before = z_mm < first;
    const double along = before ? first - z_mm : std::max(0.0, z_mm - last);
    if (along > 0 && (before ? rim.round_start : rim.round_end)) {
        const double far = std::hypot(along, aside), share = along * along / std::max(1e-12, far * far);
        return {far - half, std::sqrt(share * rim.blur_z_mm * rim.blur_z_mm + (1 - share) * rim.blur_mm * rim.blur_mm)};
    }
    double within = -1e9;  // of a straight end
    if (!rim.round_start) within = std::max(within, first - z_mm);
    if (!rim.round_end) within = std::max(within, z_mm - last);
    return within > aside - half ? RimDistance{within, rim.blur_z_mm} : RimDistance{aside - half, rim.blur_mm};
}

double areaWithin_mm2(const RimShape& rim, const RimView& view, double grown_mm)
{
    const double half = rim.width_mm() / 2, reach = half + grown_mm;
    double area = 0;
    for (const auto& [sine, wide] : strips()) {
        const double aside = reach * sine;
        const double round = std::sqrt(std::max(0.0, reach * reach - aside * aside));
        const double start = rim.round_start ? rim.start_mm + half - round : rim.start_mm - grown_mm;
        const double end = rim.round_end ? rim.end_mm - half + round : rim.end_mm + grown_mm;
        const double length = std::min(end, view.to_mm) - std::max(start, view.from_mm);
        double stretch = 1;
        if (view.radius_mm > 0) {
            const double slope = std::min(0.995, std::abs(rim.middle_mm() + aside) / view.radius_mm);
            stretch = 1 / std::sqrt(1 - slope * slope);
        }
        area += std::max(0.0, length) * reach * wide * stretch;
    }
    return area;
}

RimShape bestRim(const RimView& view, const RimShape& first, const Progress& progress)
{
    RimShape start = first;
    start.blur_mm = start.blur_z_mm = rimLimits.coarse_blur_mm;
    RimNumbers at(start);
    for (int round = 0; round < rimLimits.coarse_rounds; ++round)
        climb(RimLikelihood(view, at.shape(), rimLimits.coarse_reach_mm), at.places(), at, progress);
    start = at.shape();
    start.blur_mm = start.blur_z_mm = rimLimits.first_blur_mm;
    at = RimNumbers(start);
    const RimLikelihood likelihood(view, start, rimLimits.reach_mm);
    climb(likelihood, at.count(), at, progress);
    return at.shape();
}

double logLikelihood(const RimView& view, const RimShape& about, const RimShape& rim)
{
    return RimLikelihood(view, about, rimLimits.coarse_reach_mm).at(rim);
}

RimFit fitRim(const RimView& view, const RimShape& first, const Progress& progress)
{
    RimFit fit;
    fit.rim = bestRim(view, first, progress);
    const RimLikelihood likelihood(view, fit.rim, rimLimits.reach_mm);
    RimNumbers at(fit.rim);
    double now = likelihood.at(fit.rim);
    std::array<double, mostParameters> step{}, taken{};
    for (std::size_t k = 0; k < at.count(); ++k) step[k] = k < at.places() ? 0.05 : 0.5;
    std::array<Moments, mostParameters> moments;
    Moments width, middle;
    for (std::uint64_t sweep = 0; sweep < rimLimits.warm_up + rimLimits.samples; ++sweep) {
        progress.check();
        for (std::size_t k = 0; k < at.count(); ++k) {
            const std::uint64_t index = sweep * mostParameters + k;
            RimNumbers next = at;
            next.value[k] += step[k] * (2 * randomUniform(1, 0, index) - 1);
            const double found = likelihood.at(next.shape());
            if (!(std::log(std::max(1e-300, randomUniform(1, 1, index))) < found - now)) continue;
            at = next;
            now = found;
            taken[k] += 1;
        }
        if (sweep < rimLimits.warm_up) {
            if ((sweep + 1) % rimLimits.adapted != 0) continue;
            for (std::size_t k = 0; k < at.count(); ++k) {
                const double share = taken[k] / static_cast<double>(rimLimits.adapted);
                step[k] = std::clamp(step[k] * std::clamp(share / 0.4, 0.3, 2.0), 1e-4, 2.0);
                taken[k] = 0;
            }
            continue;
        }
        const RimShape rim = at.shape();
        width.add(rim.width_mm());
        middle.add(rim.middle_mm());
        for (std::size_t k = 0; k < at.count(); ++k) moments[k].add(at.value[k]);
    }
    RimNumbers mean = at;
    for (std::size_t k = 0; k < at.count(); ++k) mean.value[k] = moments[k].mean();
    fit.rim = mean.shape();
    fit.width_sigma_mm = width.sigma();
    fit.middle_sigma_mm = middle.sigma();
    fit.start_sigma_mm = moments[0].sigma();
    fit.end_sigma_mm = fit.rim.kind == RimKind::Circle ? moments[0].sigma() : moments[1].sigma();
    return fit;
}

}  // namespace lathelier::features
