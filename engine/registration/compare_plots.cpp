#include "engine/registration/compare_plots.h"

#include <algorithm>
#include <cmath>

#include "engine/report/colours.h"

namespace lathelier::registration {
namespace {

const Text zTitle = LT_TEXT("Engine", "Along the axis, from the first data (mm)");
const Text toleranceName = LT_TEXT("Engine", "tolerance");
const Text deviationTitle = LT_TEXT("Engine", "Deviation (mm)");

/// The share of the largest values that may run over the edge of a plot: single bins at shoulders.
constexpr double ordinaryShare = 0.98;

/// The value below which `share` of the finite |values| lie; 0 when there are none.
template <class T>
double quantileOfSize(const std::vector<T>& values, double share)
{
    std::vector<double> sizes;
    for (const T value : values)
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    if (sizes.empty()) return 0;
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    return *at;
}

/// The same length for map and curves, so that they can be read below each other.
std::optional<Interval> axisRange(const CompareResult& result)
{
    if (!result.unrolled) return std::nullopt;
    const UnrolledMap& map = *result.unrolled;
    return Interval{map.z_start_mm, map.z_start_mm + map.z_step_mm * map.z_count};
}

/// Tolerance limits as lines, when there is a tolerance.
std::vector<Limit> toleranceLimits(const CompareResult& result, Limit::Direction direction)
{
    const auto& tolerance_mm = result.parameters.tolerance_mm;
    if (!tolerance_mm) return {};
    return {{direction, -*tolerance_mm, toleranceName}, {direction, *tolerance_mm, toleranceName}};
}

}  // namespace

double colourLimit_mm(const CompareResult& result, bool with_tolerance)
{
    double wanted =
        result.unrolled ? quantileOfSize(result.unrolled->mean_mm, ordinaryShare) : result.statistics.p95_abs_mm;
    // With a tolerance the band takes at most half of the scale.
    if (with_tolerance && result.parameters.tolerance_mm)
        wanted = std::max(wanted, 2 * *result.parameters.tolerance_mm);
    return niceLimit(std::isfinite(wanted) && wanted > 0 ? wanted : 0.01);
}

ColourMap unrolledMap(const CompareResult& result, bool with_tolerance)
{
    const UnrolledMap& source = *result.unrolled;
    ColourMap map;
    map.title = with_tolerance ? LT_TEXT("Engine", "Unrolled surface: tolerance")
                               : LT_TEXT("Engine", "Unrolled surface: form of the deviation");
    map.x.title = zTitle;
    map.y.title = LT_TEXT("Engine", "Angle about the axis (°)");
    map.value.title = deviationTitle;
    map.x_from = source.z_start_mm;
    map.x_to = source.z_start_mm + source.z_step_mm * source.z_count;
    map.y_to = 360;
    map.columns = source.z_count;
    map.rows = source.angle_count;
    const auto columns = static_cast<std::size_t>(map.columns);
    const auto rows = static_cast<std::size_t>(map.rows);
    map.values.resize(columns * rows);
    for (std::size_t z = 0; z < columns; ++z)
        for (std::size_t angle = 0; angle < rows; ++angle)
            map.values[angle * columns + z] = source.mean_mm[z * rows + angle];
    map.limit = colourLimit_mm(result, with_tolerance);
    if (with_tolerance) map.tolerance = result.parameters.tolerance_mm;
    return map;
}

Plot deviationAlongAxis(const CompareResult& result)
{
    const Meridian& meridian = *result.meridian;
    Plot plot;
    plot.title = LT_TEXT("Engine", "Deviation along the axis");
    plot.x.title = zTitle;
    plot.y.title = deviationTitle;
    Curve band{
        LT_TEXT("Engine", "± one standard deviation"), meridian.z_mm, {}, Curve::Style::Band, {}, ColourRole::Copy};
    std::vector<double> ends;
    for (std::size_t i = 0; i < meridian.z_mm.size(); ++i) {
        band.y.push_back(meridian.deviation_mm[i] + meridian.std_mm[i]);
        band.y_low.push_back(meridian.deviation_mm[i] - meridian.std_mm[i]);
        ends.push_back(std::abs(meridian.deviation_mm[i]) + meridian.std_mm[i]);
    }
    double edge = quantileOfSize(ends, ordinaryShare);
    plot.curves = {
        band,
        {LT_TEXT("Engine", "mean"), meridian.z_mm, meridian.deviation_mm, Curve::Style::Line, {}, ColourRole::Copy}};
    plot.x.range = axisRange(result);
    plot.limits = toleranceLimits(result, Limit::Direction::Horizontal);
    for (const Limit& limit : plot.limits) edge = std::max(edge, std::abs(limit.place));
    if (edge > 0) plot.y.range = Interval{-1.15 * edge, 1.15 * edge};
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
    // Large enough to be seen beside the radii, small enough not to hide the shape.
    const double room_mm = 0.12 * std::max(high - low, 0.1 * high);
    const double most = room_mm / typical_mm;
    if (most < 1) return 1;
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= most) return factor * power;
    return power;
}

Plot magnifiedMeridian(const CompareResult& result, const Language& language)
{
    const Meridian& meridian = *result.meridian;
    const double factor = magnification(result);
    const double ordinary_mm = quantileOfSize(meridian.deviation_mm, ordinaryShare);
    Plot plot;
    plot.title = LT_TEXT("Engine", "Meridian");
    plot.x.title = zTitle;
    plot.y.title = LT_TEXT("Engine", "Radius (mm)");
    plot.x.range = axisRange(result);
    Curve original{LT_TEXT("Engine", "original"), meridian.z_mm, meridian.reference_radius_mm, Curve::Style::Line, {},
                   ColourRole::Original};
    const std::string name =
        fill(text(LT_TEXT("Engine", "copy, deviation × {factor}"), language), {{"factor", factor}}, language);
    Curve copy{name, meridian.z_mm, {}, Curve::Style::Line, {}, ColourRole::Copy};
    Interval shown{HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < meridian.z_mm.size(); ++i) {
        const double radius_mm = meridian.reference_radius_mm[i];
        copy.y.push_back(radius_mm + factor * meridian.deviation_mm[i]);
        if (!std::isfinite(radius_mm)) continue;
        shown.from = std::min(shown.from, radius_mm);
        shown.to = std::max(shown.to, radius_mm);
    }
    // Single bins at shoulders may run over the edge.
    const double air_mm = 1.5 * factor * ordinary_mm + 0.05 * (shown.to - shown.from);
    if (shown.from <= shown.to) plot.y.range = Interval{shown.from - air_mm, shown.to + air_mm};
    plot.curves = {original, copy};
    return plot;
}

Plot histogramPlot(const CompareResult& result)
{
    Plot plot;
    plot.title = LT_TEXT("Engine", "Histogram of the deviations");
    plot.x.title = deviationTitle;
    plot.y.title = LT_TEXT("Engine", "Points");
    Curve bars;
    bars.x = result.histogram.edges_mm;
    bars.y.assign(result.histogram.counts.begin(), result.histogram.counts.end());
    bars.style = Curve::Style::Bars;
    plot.curves = {bars};
    plot.limits = toleranceLimits(result, Limit::Direction::Vertical);
    return plot;
}

}  // namespace lathelier::registration
