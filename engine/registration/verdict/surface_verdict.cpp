#include "engine/registration/verdict/surface_verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {
namespace {

constexpr double toleratedUndecidedShare =
    0.005;  // largest share of points without a possible decision (rims, small corners)
constexpr double sureHalfWidthShare =
    0.5;  // of the half-width of the limits: with an expanded uncertainty up to it a window represents its place

/// Number of the zone that holds the stretch, or none.
std::size_t zoneOf(const std::vector<Zone>& zones, double start, double end)
{
    const auto after = std::upper_bound(zones.begin(), zones.end(), start,
                                        [](double z, const Zone& zone) { return z < zone.z_start_mm; });
    if (after == zones.begin() || (after - 1)->z_end_mm < end) return zones.size();
    return static_cast<std::size_t>(after - 1 - zones.begin());
}

/// Coverage factor of the worst place: 2 where it exceeds all others by far, so that selection has no effect; the full
/// factor for the extreme of many where noise may have caused the selection.
double chosenFactor(const SurfaceWindows& all, const SurfaceWindow& window)
{
    const double out = std::abs(static_cast<double>(window.mean_mm)) / static_cast<double>(window.sigma_mm);
    const double clear = std::clamp((out - 1.2 * all.factor) / (0.8 * all.factor), 0.0, 1.0);
    return std::isfinite(out) ? all.factor + clear * (2 - all.factor) : 2;
}

WorstPlace worstPlaceOf(const SurfaceWindows& all, const SurfaceWindow& window, double factor)
{
    WorstPlace worst;
    worst.point_mm = window.place_mm.cast<double>();
    worst.deviation_mm =
        all.has_sign ? static_cast<double>(window.mean_mm) : std::abs(static_cast<double>(window.mean_mm));
    worst.uncertainty_mm = factor * static_cast<double>(window.sigma_mm);
    worst.cell_mm = static_cast<double>(window.size_mm);
    if (all.axis_T_reference) {
        // The mean of places all round lies near the axis: the point is that of the surface in its direction.
        Eigen::Vector3d place = *all.axis_T_reference * worst.point_mm;
        worst.z_mm = (static_cast<double>(window.z_start_mm) + static_cast<double>(window.z_end_mm)) / 2;
        const double angle = std::atan2(place.y(), place.x()) * 180 / std::numbers::pi;
        worst.angle_deg = angle < 0 ? angle + 360 : angle;
        if (window.stretch >= 0) {
            const MeridianStretch& stretch = all.stretches[static_cast<std::size_t>(window.stretch)];
            const double radius =
                stretch.radius_mm + stretch.slope * (*worst.z_mm - (stretch.start_mm + stretch.end_mm) / 2);
            const double from_axis = place.head<2>().norm();
            if (stretch.isFace() && from_axis > stretch.inner_mm) return worst;
            place.head<2>() =
                from_axis > 0 ? Eigen::Vector2d(place.head<2>() * (radius / from_axis)) : Eigen::Vector2d(radius, 0);
            place.z() = *worst.z_mm;
            worst.point_mm = all.axis_T_reference->inverse() * place;
        }
    }
    return worst;
}

/// One of the smallest windows, with those that hold it.
struct WindowPlace {
    std::optional<DeviationLimits> limits;  ///< of the chosen window
    const SurfaceWindow* window =
        nullptr;  ///< the smallest with sufficient uncertainty; else the one of least uncertainty that has limits
    double needed_mm = std::numeric_limits<double>::infinity();  ///< the least U of all
    double cell_mm = 0;                                          ///< of the window that has it
};

WindowPlace chooseWindow(const SurfaceWindows& all, const LimitsAlong& limits, const SurfaceWindow& smallest)
{
    WindowPlace place;
    for (const SurfaceWindow* w = &smallest;;) {
        const auto here = limits.between(static_cast<double>(w->z_start_mm), static_cast<double>(w->z_end_mm));
        if (here) {
            const auto sigma = static_cast<double>(w->sigma_mm);
            if (2 * sigma < place.needed_mm) {
                place.needed_mm = 2 * sigma;
                place.cell_mm = static_cast<double>(w->size_mm);
            }
            if (2 * sigma <= here->half_mm() && (!place.window || w->sigma_mm < place.window->sigma_mm)) {
                place.limits = here;
                place.window = w;
            }
            if (all.factor * sigma <= sureHalfWidthShare * here->half_mm()) break;
        }
        if (w->wider == SurfaceWindow::noWiderWindow) break;
        w = &all.windows[w->wider];
    }
    return place;
}

}  // namespace

LimitsAlong::LimitsAlong(const std::optional<double>& tolerance_mm, const std::vector<ZoneLimits>& zones)
    : zones_(zones)
{
    if (tolerance_mm) elsewhere_ = DeviationLimits{-*tolerance_mm, *tolerance_mm};
    std::sort(zones_.begin(), zones_.end(),
              [](const ZoneLimits& a, const ZoneLimits& b) { return a.z_start_mm < b.z_start_mm; });
}

bool LimitsAlong::any() const
{
    return elsewhere_ ||
           std::any_of(zones_.begin(), zones_.end(), [](const ZoneLimits& z) { return z.lower_mm.has_value(); });
}

std::optional<DeviationLimits> LimitsAlong::at(double z_mm) const
{
    return between(z_mm, z_mm);
}

std::optional<DeviationLimits> LimitsAlong::between(double z_start_mm, double z_end_mm) const
{
    if (zones_.empty()) return elsewhere_;
    std::optional<DeviationLimits> widest;
    const auto take = [&widest](const DeviationLimits& limits) {
        if (!widest) widest = limits;
        widest->lower_mm = std::min(widest->lower_mm, limits.lower_mm);
        widest->upper_mm = std::max(widest->upper_mm, limits.upper_mm);
    };
    double covered_to = z_start_mm;
    bool gap = false;
    for (const ZoneLimits& zone : zones_) {
        if (zone.z_end_mm < z_start_mm || zone.z_start_mm > z_end_mm) continue;
        if (!zone.lower_mm) return std::nullopt;
        gap = gap || zone.z_start_mm > covered_to;
        covered_to = std::max(covered_to, zone.z_end_mm);
        take({*zone.lower_mm, *zone.upper_mm});
    }
    if (!widest || gap || covered_to < z_end_mm) {
        if (!elsewhere_) return std::nullopt;
        take(*elsewhere_);
    }
    return widest;
}

double judgedMean_mm(const SurfaceWindows& all, const SurfaceWindow& window)
{
    const auto mean = static_cast<double>(window.mean_mm);
    if (!all.has_sign) return std::max(0.0, std::abs(mean) - all.facets_mm);
    if (window.stretch >= 0 && all.stretches[static_cast<std::size_t>(window.stretch)].isFace()) return mean;
    // Facets lie inside the round surface: the deviation of a round copy from them is positive outside and negative in
    // a bore.
    const bool is_bore = window.stretch >= 0 && all.stretches[static_cast<std::size_t>(window.stretch)].is_bore;
    if (is_bore) return mean < 0 ? std::min(0.0, mean + all.facets_mm) : mean;
    return mean > 0 ? std::max(0.0, mean - all.facets_mm) : mean;
}

double excess_mm(const SurfaceWindows& all, double mean_mm, double allowance_mm, const DeviationLimits& limits)
{
    const double out = std::max(mean_mm - limits.upper_mm, limits.lower_mm - mean_mm);
    if (all.has_sign) return out - allowance_mm;
    return std::min(out, std::max(-mean_mm - limits.upper_mm, limits.lower_mm + mean_mm)) - allowance_mm;
}

std::optional<Verdict> WindowsVerdict::verdict() const
{
    if (fails) return Verdict::Fail;
    if (judged_points == 0) return std::nullopt;
    const double few = toleratedUndecidedShare * judged_points;
    return undecided_points > few || ambiguous_points > 0 ? Verdict::Undecided : Verdict::Pass;
}

SurfaceVerdict judgeWindows(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule,
                            const std::vector<Zone>& zones)
{
    SurfaceVerdict result;
    result.zones.resize(zones.size());
    const bool any = limits.any();
    // Small, noisy windows count only where they fail: else the worst is that of the chosen windows.
    struct Worst {
        double excess = -std::numeric_limits<double>::infinity();
        const SurfaceWindow* window = nullptr;
    };
    Worst failing;
    Worst sure;
    Worst judged;
    struct MayBeOut {
        double beyond;  ///< the limit that may be exceeded
        const SurfaceWindow* window;
    };
    std::vector<MayBeOut> may_be_out;
    for (const SurfaceWindow& window : all.windows) {
        const auto start = static_cast<double>(window.z_start_mm);
        const auto end = static_cast<double>(window.z_end_mm);
        const auto sigma = static_cast<double>(window.sigma_mm);
        const auto here = any ? limits.between(start, end) : DeviationLimits{};
        if (!here || (any && 2 * sigma > here->half_mm())) continue;
        const double beyond = excess_mm(all, judgedMean_mm(all, window), 0, *here);
        const auto take = [&](Worst& worst) {
            if (beyond - all.factor * sigma > worst.excess) worst = {beyond - all.factor * sigma, &window};
        };
        take(judged);
        const double enough = any ? sureHalfWidthShare * here->half_mm() : sureHalfWidthShare * all.scatter_mm;
        if (all.factor * sigma <= enough) take(sure);
        if (beyond + all.factor * sigma > 0) may_be_out.push_back({beyond, &window});
    }
    // One-sided: the other limit is at least four standard uncertainties further away.
    result.factor = any ? std::min(all.factor, coverageFactorOfWorst(may_be_out.size(), all.about, 1)) : all.factor;
    for (const MayBeOut& one : may_be_out) {
        const SurfaceWindow& window = *one.window;
        const double excess = one.beyond - result.factor * static_cast<double>(window.sigma_mm);
        if (excess <= 0) continue;
        if (excess > failing.excess) failing = {excess, &window};
        if (!any) continue;
        result.all.fails = true;
        const std::size_t zone =
            zoneOf(zones, static_cast<double>(window.z_start_mm), static_cast<double>(window.z_end_mm));
        if (zone < zones.size()) result.zones[zone].fails = true;
    }
    // A failing window is selected among those that may be out, any other among all windows.
    for (const Worst* worst : {&failing, &sure, &judged})
        if (worst->window && !result.worst) {
            const double most = worst == &failing ? result.factor : all.factor;
            result.worst = worstPlaceOf(all, *worst->window, std::min(most, chosenFactor(all, *worst->window)));
        }
    if (!any) return result;

    forEachSmallest(all, [&](const SurfaceWindow& window) {
        const auto middle = (static_cast<double>(window.z_start_mm) + static_cast<double>(window.z_end_mm)) / 2;
        if (!limits.at(middle)) return;
        const WindowPlace place = chooseWindow(all, limits, window);
        if (std::isinf(place.needed_mm)) return;  // at the border of what is left out
        const auto points = static_cast<double>(window.points);
        bool unsure = false;
        if (place.window && rule == DecisionRule::Guarded)
            unsure = excess_mm(all, judgedMean_mm(all, *place.window), -2 * static_cast<double>(place.window->sigma_mm),
                               *place.limits) > 0;
        const auto add = [&](WindowsVerdict& verdict) {
            verdict.judged_points += points;
            if (!place.window) {
                verdict.undecided_points += points;
                if (place.needed_mm > verdict.needed_mm) {
                    verdict.needed_mm = place.needed_mm;
                    verdict.cell_mm = place.cell_mm;
                }
            }
            if (unsure) verdict.ambiguous_points += points;
        };
        add(result.all);
        const std::size_t zone = zoneOf(zones, middle, middle);
        if (zone < zones.size()) add(result.zones[zone]);
    });
    return result;
}

}  // namespace lathelier::registration
