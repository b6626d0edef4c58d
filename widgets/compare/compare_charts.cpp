#include "widgets/compare/compare_charts.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "widgets/core/language.h"

namespace lathelier {

/// The words of these plots.
struct CompareCharts {
    Q_DECLARE_TR_FUNCTIONS(lathelier::CompareCharts)
};

namespace {

QColor toQt(Rgb c)
{
    return {c.red, c.green, c.blue};
}

const QColor blue = toQt(divergingColour(-0.9));
const QColor red = toQt(divergingColour(0.9));

QString decimals(double value)
{
    return QLocale().toString(value, 'g', 4);
}

/// The size below which `share` of the finite values lie.
double ordinarySize(const std::vector<double>& values, double share)
{
    std::vector<double> sizes;
    for (const double value : values)
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    if (sizes.empty()) return 0;
    const auto rank = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), rank, sizes.end());
    return *rank;
}

PlotAxis lengthAxis()
{
    return {CompareCharts::tr("Along the axis"), "mm"};
}

/// The profile moved outward by `shift` of each bin.
std::vector<double> shifted(const registration::Meridian& meridian, const std::function<double(std::size_t)>& shift)
{
    std::vector<double> result = meridian.reference_radius_mm;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += shift(i);
    return result;
}

}  // namespace

MapData compareMap(const registration::CompareResult& result)
{
    MapData map;
    if (!result.unrolled) return map;
    const registration::UnrolledMap& source = *result.unrolled;
    map.title = CompareCharts::tr("Unrolled surface, local means");
    map.x = lengthAxis();
    map.y = {CompareCharts::tr("Angle"), "°"};
    map.value = {CompareCharts::tr("Deviation"), "mm"};
    map.xFrom = source.z_start_mm;
    map.xTo = source.z_start_mm + source.z_step_mm * source.z_count;
    map.yTo = 360;
    map.columns = source.z_count;
    map.rows = source.angle_count;
    map.values.resize(source.mean_mm.size());
    const auto columns = static_cast<std::size_t>(map.columns);
    const auto rows = static_cast<std::size_t>(map.rows);
    for (std::size_t z = 0; z < columns; ++z)
        for (std::size_t angle = 0; angle < rows; ++angle)
            map.values[angle * columns + z] = source.mean_mm[z * rows + angle];
    return map;
}

PlotData compareMeridian(const registration::CompareResult& result, double magnification)
{
    PlotData plot;
    if (!result.meridian) return plot;
    const registration::Meridian& meridian = *result.meridian;
    plot.title = CompareCharts::tr("Meridian");
    plot.remark = CompareCharts::tr("error drawn × %1").arg(decimals(magnification));
    plot.x = lengthAxis();
    plot.y = {CompareCharts::tr("Radius"), "mm"};

    const auto deviation = [&](std::size_t i) { return meridian.deviation_mm[i]; };
    const auto band = [&](const QString& name, const QColor& colour, double sign) {
        PlotCurve curve;
        curve.name = name;
        curve.style = PlotCurve::Style::Band;
        curve.x = meridian.z_mm;
        curve.y =
            shifted(meridian, [&](std::size_t i) { return magnification * sign * std::max(0.0, sign * deviation(i)); });
        curve.yLow = meridian.reference_radius_mm;
        curve.colour = colour;
        curve.spoken = false;
        return curve;
    };
    plot.curves.push_back(band(CompareCharts::tr("excess"), red, 1));
    plot.curves.push_back(band(CompareCharts::tr("missing"), blue, -1));
    PlotCurve reference;
    reference.name = CompareCharts::tr("reference");
    reference.x = meridian.z_mm;
    reference.y = meridian.reference_radius_mm;
    reference.colour = QColor(31, 119, 180);  // as in the 3-D overlay
    PlotCurve copy;
    copy.name = CompareCharts::tr("copy");
    copy.x = meridian.z_mm;
    copy.y = shifted(meridian, [&](std::size_t i) { return magnification * deviation(i); });
    copy.readout = meridian.deviation_mm;
    copy.readoutUnit = "mm";
    copy.colour = QColor(214, 39, 40);  // as in the 3-D overlay
    plot.curves.push_back(reference);
    plot.curves.push_back(copy);
    if (const auto& tolerance_mm = result.parameters.tolerance_mm)
        for (const double sign : {1.0, -1.0}) {
            PlotCurve limit;
            if (sign > 0) limit.name = CompareCharts::tr("± %1 mm").arg(decimals(*tolerance_mm));
            limit.style = PlotCurve::Style::Dashed;
            limit.x = meridian.z_mm;
            limit.y = shifted(meridian, [&](std::size_t) { return magnification * sign * *tolerance_mm; });
            limit.colour = QColor(120, 120, 120);
            limit.spoken = false;
            plot.curves.push_back(limit);
        }
    for (const Interval& zone : result.parameters.exclude_z_mm)
        plot.regions.push_back({zone.from, zone.to, CompareCharts::tr("left out"), {}});

    // Single bins at shoulders may run over the edge: they would press everything else flat.
    double ordinary_mm = 1.3 * ordinarySize(meridian.deviation_mm, 0.97);
    if (const auto& tolerance_mm = result.parameters.tolerance_mm)  // the band is seen, unless it dwarfs the error
        ordinary_mm = std::max(ordinary_mm, std::min(1.1 * *tolerance_mm, 4 * ordinary_mm));
    const double room = magnification * ordinary_mm;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double radius : meridian.reference_radius_mm)
        if (std::isfinite(radius)) {
            low = std::min(low, radius);
            high = std::max(high, radius);
        }
    if (low <= high) plot.yRange = std::pair{low - room, high + room};
    return plot;
}

PlotData compareHistogram(const registration::CompareResult& result, double limit_mm)
{
    const registration::Histogram& histogram = result.histogram;
    PlotData plot;
    plot.title = CompareCharts::tr("Distribution of the deviations");
    plot.x = {CompareCharts::tr("Deviation"), "mm"};
    plot.y = {CompareCharts::tr("Points"), {}};
    plot.yFromZero = true;
    if (histogram.counts.empty()) return plot;
    const auto& tolerance_mm = result.parameters.tolerance_mm;

    const auto bars = [&](const QString& name, const QColor& colour, const std::function<bool(double)>& belongs) {
        PlotCurve curve;
        curve.name = name;
        curve.style = PlotCurve::Style::Bars;
        curve.colour = colour;
        for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
            const double middle = (histogram.edges_mm[i] + histogram.edges_mm[i + 1]) / 2;
            curve.x.push_back(middle);
            curve.y.push_back(belongs(middle) ? static_cast<double>(histogram.counts[i]) : std::nan(""));
        }
        plot.curves.push_back(curve);
    };
    if (tolerance_mm) {
        const double t = *tolerance_mm;
        bars(CompareCharts::tr("too small"), blue, [t](double v) { return v < -t; });
        bars(CompareCharts::tr("within"), toQt(insideColour(0)), [t](double v) { return std::abs(v) <= t; });
        bars(CompareCharts::tr("too large"), red, [t](double v) { return v > t; });
        plot.limits.push_back({Qt::Vertical, -t, QStringLiteral("−%1").arg(decimals(t)), true});
        plot.limits.push_back({Qt::Vertical, t, QStringLiteral("+%1").arg(decimals(t)), true});
    } else {
        bars(CompareCharts::tr("points"), QColor(110, 130, 150), [](double) { return true; });
    }

    const registration::DeviationStatistics& s = result.statistics;
    if (result.has_sign && s.std_mm > 0) {
        PlotCurve normal;
        normal.name = CompareCharts::tr("normal distribution");
        normal.colour = QColor(128, 128, 128);  // seen on light and dark
        const double width = histogram.edges_mm[1] - histogram.edges_mm[0];
        const double peak = static_cast<double>(s.points_used) * width / (s.std_mm * std::sqrt(2 * std::numbers::pi));
        for (int i = -200; i <= 200; ++i) {
            const double u = i / 50.0;
            normal.x.push_back(s.mean_mm + u * s.std_mm);
            normal.y.push_back(peak * std::exp(-u * u / 2));
        }
        plot.curves.push_back(normal);
    }
    double reach = std::max(limit_mm, std::abs(s.mean_mm) + 4 * s.std_mm);
    if (tolerance_mm) reach = std::max(reach, 1.3 * *tolerance_mm);
    plot.xRange = std::pair{result.has_sign ? -reach : 0.0, reach};
    return plot;
}

}  // namespace lathelier
