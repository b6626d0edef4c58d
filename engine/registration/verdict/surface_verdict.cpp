#include "engine/registration/verdict/surface_verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/registration/verdict/surface_cells.h"

namespace lathelier::registration {
namespace {

/// What a verdict needs to be sure (registration/README.md, "Thresholds").
struct SurfaceVerdictThresholds {
    /// Largest share of the surface that may be unresolved: rims, small corners. A disc of 4 mm on a place with 11
    /// points in place of 26 passed once in 200 with a larger one (tests: small_defect_test.cpp).
    double tolerated_share = 0.002;
    double sure_half_width_share = 0.5;  ///< an expanded uncertainty up to this represents its place
    double least_resolution = 2;  ///< standard uncertainties within the half-width: noisier windows are not judged
    std::size_t windows_of_one_place = 3;  ///< the windows that may be out lie about few places and overlap
    double selected_factors = 1.2;     ///< of the factor of the extreme: up to this noise may select the worst place,
    double clear_range_factors = 0.8;  ///< from this much beyond on it is clear
    double least_family = 16;          ///< added to the number of windows, whose double logarithm has to be defined
};
constexpr SurfaceVerdictThresholds verdictThresholds{};

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
    const double clear = std::clamp(
        (out - verdictThresholds.selected_factors * all.factor) / (verdictThresholds.clear_range_factors * all.factor),
        0.0, 1.0);
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

/// The windows about one of the smallest windows.
struct WindowPlace {
    std::optional<DeviationLimits> limits;  ///< of the chosen window
    /// The smallest with sufficient uncertainty, else the one of least uncertainty that is within the half-width of its
    /// limits; none up to largestDefect_mm.
    const SurfaceWindow* window = nullptr;
    double resolved_mm =
        std::numeric_limits<double>::infinity();                 ///< size of the smallest with U within the half-width
    double needed_mm = std::numeric_limits<double>::infinity();  ///< the least U of all that have limits
    double cell_mm = 0;                                          ///< of the window that has it
    bool is_at_border = false;  ///< no window about it is resolved, and some reach into what has no limits
};

WindowPlace chooseWindow(const SurfaceWindows& all, const LimitsAlong& limits, const SurfaceWindow& smallest)
{
    WindowPlace place;
    for (const SurfaceWindow* w = &smallest; &smallest == w || static_cast<double>(w->size_mm) <= largestDefect_mm;) {
        const auto here = limits.between(static_cast<double>(w->z_start_mm), static_cast<double>(w->z_end_mm));
        if (here) {
            const double U_mm = all.factor * static_cast<double>(w->sigma_mm);
            if (U_mm < place.needed_mm) {
                place.needed_mm = U_mm;
                place.cell_mm = static_cast<double>(w->size_mm);
            }
            if (U_mm <= here->half_mm()) {
                place.is_at_border = false;
                if (U_mm == 0) place.resolved_mm = 0;  // a surface known without noise: its facets hide nothing
                place.resolved_mm = std::min(place.resolved_mm, static_cast<double>(w->size_mm));
                if (!place.window || w->sigma_mm < place.window->sigma_mm) {
                    place.limits = here;
                    place.window = w;
                }
            }
            if (U_mm <= verdictThresholds.sure_half_width_share * here->half_mm()) break;
        } else if (!place.window) {
            place.is_at_border = true;
        }
        if (w->wider == SurfaceWindow::noWiderWindow) break;
        w = &all.windows[w->wider];
    }
    return place;
}

/// The most extreme window of one kind.
struct Extreme {
    double by = -std::numeric_limits<double>::infinity();
    const SurfaceWindow* window = nullptr;

    void take(double value, const SurfaceWindow& candidate)
    {
        if (value > by) *this = {value, &candidate};
    }
};

/// Whether a mean beyond the limit is what noise makes of a surface within: a wider window about the place, much surer,
/// is within the limit, and the mean differs from it by no more than the extreme of many does.
bool isNoise(const SurfaceWindows& all, const LimitsAlong& limits, const SurfaceWindow& window)
{
    const double mean_mm = judgedMean_mm(all, window);
    for (const SurfaceWindow* w = &window; w->wider != SurfaceWindow::noWiderWindow;) {
        w = &all.windows[w->wider];
        if (w->sigma_mm > window.sigma_mm / 2) continue;
        const auto here = limits.between(static_cast<double>(w->z_start_mm), static_cast<double>(w->z_end_mm));
        const double wide_mm = judgedMean_mm(all, *w);
        if (!here || excess_mm(all, wide_mm, 0, *here) > 0) continue;
        if (std::abs(mean_mm - wide_mm) <= all.factor * static_cast<double>(window.sigma_mm)) return true;
    }
    return false;
}

/// A window and how far its mean lies beyond its limits.
struct Beyond {
    double by_mm;
    double half_mm;  ///< half-width of the limits
    const SurfaceWindow* window;
};

/// Without limits: the place of the most significant deviation from zero.
std::optional<WorstPlace> mostSignificant(const SurfaceWindows& all)
{
    Extreme sure, any;
    for (const SurfaceWindow& window : all.windows) {
        const double U_mm = all.factor * static_cast<double>(window.sigma_mm);
        const double beyond_mm = std::abs(judgedMean_mm(all, window)) - U_mm;
        any.take(beyond_mm, window);
        if (U_mm <= verdictThresholds.sure_half_width_share * all.scatter_mm) sure.take(beyond_mm, window);
    }
    const SurfaceWindow* window = sure.window ? sure.window : any.window;
    if (!window) return std::nullopt;
    return worstPlaceOf(all, *window, std::min(all.factor, chosenFactor(all, *window)));
}

/// The verdicts of all windows and of each zone, while they are formed.
class VerdictsByZone {
public:
    VerdictsByZone(const std::vector<Zone>& zones, SurfaceVerdict& result) : zones_(zones), result_(result)
    {
        result.zones.resize(zones.size());
    }

    /// Calls change(verdict) for that of all windows and for that of the zone that holds the stretch.
    template <class Change>
    void at(double z_start_mm, double z_end_mm, const Change& change)
    {
        change(result_.all);
        const std::size_t zone = zoneOf(zones_, z_start_mm, z_end_mm);
        if (zone < zones_.size()) change(result_.zones[zone]);
    }

private:
    const std::vector<Zone>& zones_;
    SurfaceVerdict& result_;
};

/// The most extreme windows of the verdict: those that fail, exceed their limit without being surely out, or are
/// ambiguous by the guarded rule; and the nearest to its limit, of those that surely represent their place and of all.
struct Extremes {
    Extreme failing, exceeding, ambiguous, inside, judged;
};

/// The windows that may be beyond their limits. Those surely within are left out (Hansen, section 3.1).
std::vector<Beyond> mayBeOut(const SurfaceWindows& all, const LimitsAlong& limits, Extremes& extremes)
{
    const double clearly_within =
        std::sqrt(2 * std::log(std::log(static_cast<double>(all.windows.size()) + verdictThresholds.least_family)));
    std::vector<Beyond> may_be_out;
    for (const SurfaceWindow& window : all.windows) {
        const auto sigma = static_cast<double>(window.sigma_mm);
        const auto here = limits.between(static_cast<double>(window.z_start_mm), static_cast<double>(window.z_end_mm));
        if (!here || verdictThresholds.least_resolution * sigma > here->half_mm()) continue;
        const double beyond = excess_mm(all, judgedMean_mm(all, window), 0, *here);
        extremes.judged.take(beyond - all.factor * sigma, window);
        if (all.factor * sigma <= verdictThresholds.sure_half_width_share * here->half_mm())
            extremes.inside.take(beyond - all.factor * sigma, window);
        if (beyond + clearly_within * sigma > 0) may_be_out.push_back({beyond, here->half_mm(), &window});
    }
    return may_be_out;
}

/// The verdicts of means beyond their limits. `factor`: SurfaceVerdict::factor.
void judgeBeyond(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule,
                 const std::vector<Beyond>& may_be_out, double factor, VerdictsByZone& verdicts, Extremes& extremes)
{
    for (const Beyond& one : may_be_out) {
        if (one.by_mm <= 0) continue;
        const auto sigma = static_cast<double>(one.window->sigma_mm);
        const bool surely = one.by_mm > factor * sigma;
        if (!surely && isNoise(all, limits, *one.window)) continue;
        const bool fails = surely || (rule == DecisionRule::Simple && all.factor * sigma <= one.half_mm);
        (fails ? extremes.failing : extremes.exceeding).take(one.by_mm - factor * sigma, *one.window);
        verdicts.at(static_cast<double>(one.window->z_start_mm), static_cast<double>(one.window->z_end_mm),
                    [&](WindowsVerdict& verdict) { (fails ? verdict.fails : verdict.unsure) = true; });
    }
}

/// How large a defect is seen at each place; by the guarded rule also whether the place is surely within its limits.
void judgePlaces(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule, VerdictsByZone& verdicts,
                 Extremes& extremes)
{
    forEachSmallest(all, [&](const SurfaceWindow& window) {
        const auto middle = (static_cast<double>(window.z_start_mm) + static_cast<double>(window.z_end_mm)) / 2;
        if (!limits.at(middle)) return;
        const WindowPlace place = chooseWindow(all, limits, window);
        if (place.is_at_border) return;
        bool unsure = false;
        if (place.window && rule == DecisionRule::Guarded) {
            const double U_mm = all.factor * static_cast<double>(place.window->sigma_mm);
            const double mean_mm = judgedMean_mm(all, *place.window);
            unsure = judgeMean(all, mean_mm, U_mm, *place.limits, rule) != Verdict::Pass;
            if (unsure) extremes.ambiguous.take(excess_mm(all, mean_mm, -U_mm, *place.limits), *place.window);
        }
        verdicts.at(middle, middle, [&](WindowsVerdict& verdict) {
            verdict.resolved_mm.push_back(static_cast<float>(place.resolved_mm));
            verdict.unsure = verdict.unsure || unsure;
            if (!place.window && place.needed_mm > verdict.needed_mm) {
                verdict.needed_mm = place.needed_mm;
                verdict.cell_mm = place.cell_mm;
            }
        });
    });
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

Verdict judgeMean(const SurfaceWindows& all, double mean_mm, double expanded_uncertainty_mm,
                  const DeviationLimits& limits, DecisionRule rule)
{
    const double excess = excess_mm(all, mean_mm, 0, limits);
    if (expanded_uncertainty_mm <= limits.half_mm()) return judge(excess, expanded_uncertainty_mm, 0, rule);
    return excess > expanded_uncertainty_mm ? Verdict::Fail : Verdict::Undecided;
}

double WindowsVerdict::defect_mm() const
{
    std::vector<float> sizes = resolved_mm;
    return sizes.empty() ? 0 : static_cast<double>(lowerQuantileInPlace(sizes, 1 - verdictThresholds.tolerated_share));
}

std::optional<Verdict> WindowsVerdict::verdict(DecisionRule rule) const
{
    if (fails) return Verdict::Fail;
    if (resolved_mm.empty()) return std::nullopt;
    const double wanted = rule == DecisionRule::Guarded ? leastDefect_mm : plainDefect_mm;
    return unsure || defect_mm() > wanted ? Verdict::Undecided : Verdict::Pass;
}

SurfaceVerdict judgeWindows(const SurfaceWindows& all, const LimitsAlong& limits, DecisionRule rule,
                            const std::vector<Zone>& zones)
{
    SurfaceVerdict result;
    VerdictsByZone verdicts(zones, result);
    if (!limits.any()) {
        result.worst = mostSignificant(all);
        result.factor = all.factor;
        return result;
    }
    Extremes extremes;
    const std::vector<Beyond> may_be_out = mayBeOut(all, limits, extremes);
    // One-sided: the other limit is at least three standard uncertainties further away.
    result.factor = std::min(
        all.factor, coverageFactorOfWorst(may_be_out.size(), verdictThresholds.windows_of_one_place * all.about, 1));
    judgeBeyond(all, limits, rule, may_be_out, result.factor, verdicts, extremes);
    judgePlaces(all, limits, rule, verdicts, extremes);
    const auto& [failing, exceeding, ambiguous, inside, judged] = extremes;
    for (const Extreme* worst : {&failing, &exceeding, &ambiguous, &inside, &judged})
        if (worst->window && !result.worst)
            result.worst = worstPlaceOf(all, *worst->window,
                                        worst == &failing || worst == &exceeding ? result.factor : all.factor);
    return result;
}

}  // namespace lathelier::registration
