#include "engine/registration/compare_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/skin.h"
#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/registration/surface_form.h"
#include "engine/registration/verdict/surface_verdict.h"
#include "engine/report/colours.h"

namespace lathelier::registration {
namespace {

const report::Axis zAxis{LT_TEXT("Engine", "Along the axis, from the first data"), unit::mm};
const report::Axis deviationAxis{LT_TEXT("Engine", "Deviation"), unit::mm};
const report::Axis shareAxis{LT_TEXT("Engine", "Share of the limits"), unit::percent};

/// Share of the values that may exceed the range of a plot: single bins at shoulders.
constexpr double ordinaryShare = 0.98;

/// The value below which `share` of the finite |values| lie; 0 when there are none.
template <class T>
double quantileOfSize(const std::vector<T>& values, double share)
{
    std::vector<double> sizes;
    for (const T value : values)
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    return sizes.empty() ? 0 : lowerQuantileInPlace(sizes, share);
}

/// The same length for map and curves, so that they can be read below each other.
std::optional<Interval> axisRange(const CompareResult& result)
{
    if (!result.unrolled) return std::nullopt;
    const UnrolledMap& map = *result.unrolled;
    return Interval{map.z_start_mm, map.z_start_mm + map.z_step_mm * map.z_count};
}

/// "+0.05": a limit by its value, in the unit that is shown.
std::string signedNumber(double value_mm, const Language& language)
{
    return (value_mm < 0 ? "−" : "+") + text(shownValue(std::abs(value_mm), millimetre, language), language);
}

/// Zones with their names and limits, and excluded zones.
void addZones(report::Plot& plot, const CompareParameters& parameters)
{
    for (const Interval& left_out : parameters.exclude_z_mm)
        plot.regions.push_back(report::stretch(plot.regions.empty() ? LT_TEXT("Engine", "left out") : Text{}, left_out,
                                               report::ColourRole::Neutral));
    for (const ZoneLimits& zone : parameters.zones) {
        plot.regions.push_back(report::stretch(Text{}, {zone.z_start_mm, zone.z_end_mm}, report::ColourRole::Original));
        const double middle = (zone.z_start_mm + zone.z_end_mm) / 2;
        if (!zone.lower_mm) {
            plot.marks.push_back({middle, 0, zone.name});
            continue;
        }
        for (const double limit_mm : {*zone.lower_mm, *zone.upper_mm}) {
            report::Curve line{{}, {zone.z_start_mm, zone.z_end_mm}, {limit_mm, limit_mm}};
            line.style = report::Curve::Style::Dashed;
            line.colour = report::ColourRole::Limit;
            line.has_readout = false;
            plot.curves.push_back(std::move(line));
        }
        plot.marks.push_back({middle, *zone.upper_mm, zone.name});
    }
}

/// Radii that the magnified meridian shows. Single bins at shoulders may exceed the range: they would compress all
/// other values.
std::optional<Interval> meridianRange(const CompareResult& result, double factor)
{
    const Meridian& meridian = *result.meridian;
    double ordinary_mm = 1.3 * quantileOfSize(meridian.deviation_mm, ordinaryShare);
    if (const auto& tolerance_mm = result.parameters.tolerance_mm)  // shown unless it is much larger than the error
        ordinary_mm = std::max(ordinary_mm, std::min(1.1 * *tolerance_mm, 4 * ordinary_mm));
    Interval shown{HUGE_VAL, -HUGE_VAL};
    for (const double radius : meridian.reference_radius_mm)
        if (std::isfinite(radius)) shown = {std::min(shown.from, radius), std::max(shown.to, radius)};
    const double air_mm = factor * ordinary_mm + 0.05 * (shown.to - shown.from);
    if (!(shown.from <= shown.to)) return std::nullopt;
    return Interval{shown.from - air_mm, shown.to + air_mm};
}

/// Histogram of the shares of each point's limits; the outermost bars hold what lies beyond.
report::Plot shareHistogram(const CompareResult& result)
{
    constexpr int barCount = 80;
    const double width = 2 * shareLimit_percent / barCount;
    std::vector<double> edges;
    for (int k = 0; k <= barCount; ++k) edges.push_back(-shareLimit_percent + k * width);
    std::vector<double> counts(barCount, 0);
    const std::vector<float> shares =
        sharesOfLimits_percent(result.parameters, result.deviation_mm, result.windows->z_mm);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (!result.used[i] || std::isnan(shares[i])) continue;
        const double bar = (static_cast<double>(shares[i]) + shareLimit_percent) / width;
        counts[static_cast<std::size_t>(std::clamp(bar, 0.0, barCount - 1.0))] += 1;
    }
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Histogram of the shares of the limits");
    plot.x = shareAxis;
    plot.x.range = Interval{-shareLimit_percent, shareLimit_percent};
    plot.y.title = LT_TEXT("Engine", "Points");
    const auto bars = [&](const Text& name, report::ColourRole colour, double from, double to) {
        report::Curve curve{name, edges, {}, report::Curve::Style::Bars, {}, colour};
        for (std::size_t k = 0; k < counts.size(); ++k) {
            const double middle = edges[k] + width / 2;
            curve.y.push_back(middle > from && middle < to ? counts[k] : std::nan(""));
        }
        plot.curves.push_back(std::move(curve));
    };
    bars(LT_TEXT("Engine", "too small"), report::ColourRole::Missing, -HUGE_VAL, -100);
    bars(LT_TEXT("Engine", "within"), report::ColourRole::Within, -100, 100);
    bars(LT_TEXT("Engine", "too large"), report::ColourRole::Excess, 100, HUGE_VAL);
    return plot;
}

}  // namespace

bool showsShares(const CompareParameters& parameters)
{
    return std::ranges::any_of(parameters.zones, [](const ZoneLimits& zone) { return zone.lower_mm.has_value(); });
}

std::vector<float> sharesOfLimits_percent(const CompareParameters& parameters, std::span<const float> deviation_mm,
                                          std::span<const float> z_mm)
{
    const LimitsAlong limits(parameters.tolerance_mm, parameters.zones);
    std::vector<float> shares(deviation_mm.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (std::isnan(z_mm[i])) continue;
        const auto here = limits.at(static_cast<double>(z_mm[i]));
        if (!here) continue;
        const double middle = (here->lower_mm + here->upper_mm) / 2;
        shares[i] =
            static_cast<float>(100 * (static_cast<double>(deviation_mm[i]) - middle) / std::max(here->half_mm(), 1e-9));
    }
    return shares;
}

double colourLimit_mm(const CompareResult& result, bool with_tolerance)
{
    double wanted = result.windows ? formLimit_mm(*result.windows, ordinaryShare) : 0;
    if (!(wanted > 0))
        wanted =
            result.unrolled ? quantileOfSize(result.unrolled->mean_mm, ordinaryShare) : result.statistics.p95_abs_mm;
    // With a tolerance the band takes at most half of the scale.
    if (with_tolerance && result.parameters.tolerance_mm)
        wanted = std::max(wanted, 2 * *result.parameters.tolerance_mm);
    return report::niceLimit(std::isfinite(wanted) && wanted > 0 ? wanted : 0.01);
}

double colourSigmaLimit_mm(const CompareResult& result)
{
    return uncertaintyShareOfScale * colourLimit_mm(result, false);
}

std::vector<float> localMeansOfMap(const CompareResult& result, const Progress& progress)
{
    if (!result.windows || result.windows->windows.empty()) return result.unrolled->mean_mm;
    return meansOf(*result.windows, windowsOfMap(result, progress), colourSigmaLimit_mm(result));
}

report::ColourMap unrolledMap(const CompareResult& result, bool with_tolerance, std::span<const float> form_mm)
{
    const UnrolledMap& source = *result.unrolled;
    const std::vector<float> computed = form_mm.empty() ? localMeansOfMap(result) : std::vector<float>();
    const std::span<const float> values = form_mm.empty() ? std::span<const float>(computed) : form_mm;
    report::ColourMap map;
    map.title = with_tolerance ? LT_TEXT("Engine", "Unrolled surface: tolerance")
                               : LT_TEXT("Engine", "Unrolled surface: form of the deviation");
    map.x = zAxis;
    map.y = {LT_TEXT("Engine", "Angle about the axis"), unit::deg};
    map.value = deviationAxis;
    map.x_from = source.z_start_mm;
    map.x_to = source.z_start_mm + source.z_step_mm * source.z_count;
    map.y_to = 360;
    map.columns = source.z_count;
    map.rows = source.angle_count;
    const auto columns = static_cast<std::size_t>(map.columns);
    const auto rows = static_cast<std::size_t>(map.rows);
    map.values.resize(columns * rows);
    for (std::size_t z = 0; z < columns; ++z)
        for (std::size_t angle = 0; angle < rows; ++angle) map.values[angle * columns + z] = values[z * rows + angle];
    map.limit = colourLimit_mm(result, with_tolerance);
    if (with_tolerance && showsShares(result.parameters)) {
        std::vector<float> z_mm;
        for (std::size_t at = 0; at < map.values.size(); ++at)
            z_mm.push_back(
                static_cast<float>(source.z_start_mm + source.z_step_mm * (static_cast<double>(at % columns) + 0.5)));
        map.values = sharesOfLimits_percent(result.parameters, map.values, z_mm);
        map.value = shareAxis;
        map.limit = shareLimit_percent;
        map.tolerance = 100;
    } else if (with_tolerance)
        map.tolerance = result.parameters.tolerance_mm;
    else {
        map.steps = report::contourSteps;
        map.marked = result.parameters.tolerance_mm;
    }
    return map;
}

report::Plot deviationAlongAxis(const CompareResult& result, const Language& language)
{
    const Meridian& meridian = *result.meridian;
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Deviation along the axis");
    plot.x = zAxis;
    plot.x.range = axisRange(result);
    plot.y = deviationAxis;
    report::Curve band{LT_TEXT("Engine", "± one standard deviation"), meridian.z_mm, {}, report::Curve::Style::Band};
    report::Curve mean{LT_TEXT("Engine", "mean"), meridian.z_mm, meridian.deviation_mm};
    band.colour = mean.colour = report::ColourRole::Copy;
    std::vector<double> ends;
    for (std::size_t i = 0; i < meridian.z_mm.size(); ++i) {
        band.y.push_back(meridian.deviation_mm[i] + meridian.std_mm[i]);
        band.y_low.push_back(meridian.deviation_mm[i] - meridian.std_mm[i]);
        ends.push_back(std::abs(meridian.deviation_mm[i]) + meridian.std_mm[i]);
    }
    plot.curves = {std::move(band), std::move(mean)};
    double edge = quantileOfSize(ends, ordinaryShare);
    if (const auto& tolerance_mm = result.parameters.tolerance_mm) {
        edge = std::max(edge, *tolerance_mm);
        for (const double limit_mm : {-*tolerance_mm, *tolerance_mm})
            plot.limits.push_back({report::Limit::Direction::Horizontal, limit_mm, signedNumber(limit_mm, language)});
    }
    for (const ZoneLimits& zone : result.parameters.zones)
        if (zone.lower_mm) edge = std::max({edge, std::abs(*zone.lower_mm), std::abs(*zone.upper_mm)});
    if (edge > 0) plot.y.range = Interval{-1.15 * edge, 1.15 * edge};
    addZones(plot, result.parameters);
    return plot;
}

double magnification(const CompareResult& result)
{
    const Meridian& meridian = *result.meridian;
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const double radius_mm : meridian.reference_radius_mm)
        if (std::isfinite(radius_mm)) {
            low = std::min(low, radius_mm);
            high = std::max(high, radius_mm);
        }
    const double typical_mm = quantileOfSize(meridian.deviation_mm, 0.95);
    if (!(high >= low) || !(typical_mm > 0)) return 1;
    // Visible beside the radii without distorting the shape.
    const double room_mm = 0.35 * std::max(high - low, 0.1 * high);
    double most = room_mm / typical_mm;
    // A face moves along the axis: not further than a tenth of the part.
    const double length_mm = meridian.z_mm.back() - meridian.z_mm.front();
    if (result.windows)
        for (const SurfaceRow& face : result.windows->faces)
            if (face.mean_mm != 0) most = std::min(most, 0.1 * length_mm / std::abs(face.mean_mm));
    return readableFactor(most);
}

report::Plot magnifiedMeridian(const CompareResult& result, const Language& language,
                               std::optional<double> wanted_factor)
{
    const Meridian& meridian = *result.meridian;
    const double factor = wanted_factor.value_or(magnification(result));
    const auto& tolerance_mm = result.parameters.tolerance_mm;
    const std::vector<double>& radius_mm = meridian.reference_radius_mm;
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Meridian");
    plot.remark = fill(text(LT_TEXT("Engine", "error drawn × {factor}"), language), {{"factor", factor}}, language);
    plot.x = zAxis;
    plot.x.range = axisRange(result);
    plot.y = {LT_TEXT("Engine", "Radius"), unit::mm};
    /// The original's radius plus a magnified quantity of each place.
    const auto curve = [&](const report::Caption& name, report::Curve::Style style, report::ChartColour colour,
                           const auto& added_mm) {
        report::Curve drawn{name, meridian.z_mm, radius_mm, style, {}, colour};
        for (std::size_t i = 0; i < radius_mm.size(); ++i) drawn.y[i] += factor * added_mm(i);
        if (style == report::Curve::Style::Band) drawn.y_low = radius_mm;
        drawn.has_readout = style == report::Curve::Style::Line;
        return drawn;
    };
    const auto deviation = [&](std::size_t i) { return meridian.deviation_mm[i]; };
    plot.curves = {curve(LT_TEXT("Engine", "excess"), report::Curve::Style::Band, report::ColourRole::Excess,
                         [&](std::size_t i) { return std::max(0.0, deviation(i)); }),
                   curve(LT_TEXT("Engine", "missing"), report::Curve::Style::Band, report::ColourRole::Missing,
                         [&](std::size_t i) { return std::min(0.0, deviation(i)); }),
                   curve(LT_TEXT("Engine", "original"), report::Curve::Style::Line, report::ColourRole::Original,
                         [](std::size_t) { return 0; }),
                   curve(LT_TEXT("Engine", "copy"), report::Curve::Style::Line, report::ColourRole::Copy, deviation)};
    plot.curves.back().readout_y = meridian.deviation_mm;
    plot.curves.back().readout_unit = unit::mm;
    const LimitsAlong limits(tolerance_mm, result.parameters.zones);
    const bool zoned = showsShares(result.parameters);
    if (limits.any())
        for (const bool upper : {true, false}) {
            report::Caption caption{std::string()};
            if (upper) {
                if (zoned)
                    caption = LT_TEXT("Engine", "limits");
                else
                    caption = "± " + text(Value(*tolerance_mm), language) + " mm";
            }
            plot.curves.push_back(
                curve(caption, report::Curve::Style::Dashed, report::ColourRole::Neutral, [&](std::size_t i) {
                    const auto here = limits.at(meridian.z_mm[i]);
                    return !here ? notANumber : upper ? here->upper_mm : here->lower_mm;
                }));
        }
    for (const Interval& zone : result.parameters.exclude_z_mm)
        plot.regions.push_back(report::stretch(plot.regions.empty() ? LT_TEXT("Engine", "left out") : Text{}, zone,
                                               report::ColourRole::Neutral));

    plot.y.range = meridianRange(result, factor);
    return plot;
}

report::Plot histogramPlot(const CompareResult& result, const Language& language, std::optional<double> limit_mm)
{
    if (showsShares(result.parameters) && result.windows && !result.windows->z_mm.empty())
        return shareHistogram(result);
    const Histogram& histogram = result.histogram;
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Histogram of the deviations");
    plot.x = deviationAxis;
    plot.y.title = LT_TEXT("Engine", "Points");
    if (histogram.counts.empty()) return plot;
    const auto& tolerance_mm = result.parameters.tolerance_mm;
    const auto bars = [&](const report::Caption& name, report::ChartColour colour, const auto& belongs) {
        report::Curve curve{name, histogram.edges_mm, {}, report::Curve::Style::Bars, {}, colour};
        for (std::size_t i = 0; i < histogram.counts.size(); ++i)
            curve.y.push_back(belongs((histogram.edges_mm[i] + histogram.edges_mm[i + 1]) / 2)
                                  ? static_cast<double>(histogram.counts[i])
                                  : std::nan(""));
        plot.curves.push_back(std::move(curve));
    };
    const DeviationStatistics& s = result.statistics;
    double reach = std::max(limit_mm.value_or(colourLimit_mm(result)), std::abs(s.mean_mm) + 4 * s.std_mm);
    if (tolerance_mm) {
        const double t = *tolerance_mm;
        bars(LT_TEXT("Engine", "too small"), report::ColourRole::Missing, [t](double v) { return v < -t; });
        bars(LT_TEXT("Engine", "within"), report::ColourRole::Within, [t](double v) { return std::abs(v) <= t; });
        bars(LT_TEXT("Engine", "too large"), report::ColourRole::Excess, [t](double v) { return v > t; });
        for (const double place : {-t, t})
            plot.handles.push_back({place < 0 ? "lower" : "upper", report::Handle::Kind::Vertical, place, 0,
                                    signedNumber(place, language)});
        reach = std::max(reach, 1.3 * t);
    } else {
        bars(LT_TEXT("Engine", "points"), report::ColourRole::Neutral, [](double) { return true; });
    }
    if (result.has_sign && s.std_mm > 0) {
        report::Curve normal{LT_TEXT("Engine", "normal distribution")};
        normal.colour = report::ColourRole::Neutral;
        const double width = histogram.edges_mm[1] - histogram.edges_mm[0];
        const double peak = static_cast<double>(s.points_used) * width / (s.std_mm * std::sqrt(2 * std::numbers::pi));
        for (int i = -200; i <= 200; ++i) {
            const double u = i / 50.0;
            normal.x.push_back(s.mean_mm + u * s.std_mm);
            normal.y.push_back(peak * std::exp(-u * u / 2));
        }
        plot.curves.push_back(std::move(normal));
    }
    if (reach > 0) plot.x.range = Interval{result.has_sign ? -reach : 0.0, reach};
    return plot;
}

}  // namespace lathelier::registration
