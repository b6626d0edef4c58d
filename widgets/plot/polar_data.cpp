#include "widgets/plot/polar_data.h"

#include <QString>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/units.h"
#include "widgets/plot/plot_style.h"

namespace lathelier::plot {

namespace {

constexpr int bins = 3600;
constexpr double largestGap_deg = 15;  // wider gaps are not closed by a line

double radians(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

double turned(double angle_deg)
{
    const double rest = std::fmod(angle_deg, 360);
    return rest < 0 ? rest + 360 : rest;
}

/// Between two directions, 0…180.
double away(double a_deg, double b_deg)
{
    return std::abs(std::remainder(a_deg - b_deg, 360));
}

/// First, lowest, highest and last of a run of samples, in their order.
void addRun(PolarLine& line, const report::PolarPlot::Trace& trace, std::size_t begin, std::size_t end)
{
    std::size_t low = begin, high = begin;
    for (std::size_t i = begin; i < end; ++i) {
        if (trace.deviation_um[i] < trace.deviation_um[low]) low = i;
        if (trace.deviation_um[i] > trace.deviation_um[high]) high = i;
    }
    std::array<std::size_t, 4> kept{begin, std::min(low, high), std::max(low, high), end - 1};
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (k > 0 && kept[k] == kept[k - 1]) continue;
        line.angle_deg.push_back(trace.angle_deg[kept[k]]);
        line.deviation_um.push_back(trace.deviation_um[kept[k]]);
    }
}

PolarLine lineOf(const report::PolarPlot::Trace& trace)
{
    PolarLine line;
    const std::size_t count = std::min(trace.angle_deg.size(), trace.deviation_um.size());
    const auto drawable = [&](std::size_t i) {
        return std::isfinite(trace.angle_deg[i]) && std::isfinite(trace.deviation_um[i]);
    };
    const auto bin = [&](std::size_t i) { return std::floor(trace.angle_deg[i] / 360 * bins); };
    const auto breakLine = [&] {
        if (line.angle_deg.empty() || std::isnan(line.angle_deg.back())) return;
        line.angle_deg.push_back(notANumber);
        line.deviation_um.push_back(notANumber);
    };
    for (std::size_t i = 0; i < count;) {
        if (!drawable(i)) {
            breakLine();
            ++i;
            continue;
        }
        if (!line.angle_deg.empty() && away(trace.angle_deg[i], line.angle_deg.back()) > largestGap_deg) breakLine();
        std::size_t end = i + 1;
        while (end < count && drawable(end) && bin(end) == bin(i)) ++end;
        addRun(line, trace, i, end);
        i = end;
    }
    if (line.angle_deg.size() > 2 && !std::isnan(line.angle_deg.back()))
        line.closed = away(line.angle_deg.front(), line.angle_deg.back()) <= largestGap_deg;
    return line;
}

double rounded(double value, bool up)
{
    if (!(value > 0) || !std::isfinite(value)) return 1;
    const double power = std::pow(10, std::floor(std::log10(value)));
    const double lead = value / power;
    static constexpr std::array<double, 4> steps{1, 2, 5, 10};
    if (up)
        for (const double step : steps)
            if (lead <= step * (1 + 1e-9)) return step * power;
    double best = 1;
    for (const double step : steps)
        if (step <= lead * (1 + 1e-9)) best = step;
    return best * power;
}

double baseOf(const report::PolarPlot& plot)
{
    return plot.base_radius_mm > 0 ? plot.base_radius_mm : 1;
}

}  // namespace

double deviationAt(const report::PolarPlot::ReferenceLine& circle, double base_radius_mm, double angle_deg)
{
    const double c = std::cos(radians(angle_deg)), s = std::sin(radians(angle_deg));
    const double along_um = circle.x_um * c + circle.y_um * s;
    const double across_um = circle.y_um * c - circle.x_um * s;
    const double radius_um = base_radius_mm * 1000 + circle.deviation_um;
    if (base_radius_mm <= 0) return along_um + circle.deviation_um;
    const double inside = radius_um * radius_um - across_um * across_um;
    return inside < 0 ? notANumber : along_um + std::sqrt(inside) - base_radius_mm * 1000;
}

PolarPicturePtr polarPicture(report::PolarPlot plot, std::size_t withoutReadout)
{
    auto picture = std::make_shared<PolarPicture>();
    picture->without_readout = withoutReadout;
    picture->plot = std::move(plot);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto see = [&](double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    };
    for (const report::PolarPlot::Trace& trace : picture->plot.traces) {
        picture->lines.push_back(lineOf(trace));
        for (const double value : picture->lines.back().deviation_um) see(value);
    }
    for (const report::PolarPlot::ReferenceLine& circle : picture->plot.circles)
        for (int angle = 0; angle < 360 && circle.asked.empty(); angle += 10)
            see(deviationAt(circle, picture->plot.base_radius_mm, angle));
    for (const report::PolarPlot::Mark& mark : picture->plot.contacts) see(mark.deviation_um);
    if (low <= high) {
        picture->lowest_um = low;
        picture->highest_um = high;
    }
    return picture;
}

std::optional<std::size_t> nearestSample(const report::PolarPlot::Trace& trace, double angle_deg)
{
    std::optional<std::size_t> nearest;
    double least = 5;
    const std::size_t count = std::min(trace.angle_deg.size(), trace.deviation_um.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(trace.deviation_um[i])) continue;
        const double distance = away(trace.angle_deg[i], angle_deg);
        if (distance >= least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

PolarScale::PolarScale(double share_per_um, const PolarPicture& picture, const QPointF& centre, double room_px)
    : share_(share_per_um), centre_(centre), room_px_(room_px)
{
    // The base circle is reduced to make space for outward deviations, down to a least radius.
    base_px_ = room_px / (1 + std::clamp(share_per_um * picture.highest_um * 1.06, 0.06, 1.2));
}

QPointF PolarScale::at(double angle_deg, double deviation_um) const
{
    const double radius = std::max(0.0, base_px_ * (1 + share_ * deviation_um));
    return centre_ + radius * QPointF(std::cos(radians(angle_deg)), -std::sin(radians(angle_deg)));
}

double PolarScale::angleOf(const QPointF& place) const
{
    const QPointF arm = place - centre_;
    return turned(std::atan2(-arm.y(), arm.x()) * 180 / std::numbers::pi);
}

double fittingMagnification(const PolarPicture& picture)
{
    // One-sided deviations (inscribed or circumscribed circle) use the space of both sides.
    const double inward_um = std::max(-picture.lowest_um, 1e-6);
    const double range_um = std::max(picture.highest_um, 0.0) + inward_um;
    return rounded(std::min(1.0 / range_um, 0.65 / inward_um) * baseOf(picture.plot) * 1000, false);
}

double steppedMagnification(double magnification, int steps)
{
    for (; steps > 0; --steps) magnification = rounded(magnification * 1.5, true);
    for (; steps < 0; ++steps) magnification = rounded(magnification / 1.5, false);
    return std::clamp(magnification, 1.0, 1e9);
}

double division_um(const PolarScale& scale, double smallest_px, double factor)
{
    return rounded(smallest_px / scale.pixelsPerUm() * factor, true) / factor;
}

QString toCsv(const report::PolarPlot& plot)
{
    QString text = QStringLiteral("trace,angle_deg,deviation_um\n");
    const auto number = [](double value) { return QString::number(value, 'g', 17); };
    const auto add = [&](QString name, double angle_deg, double deviation) {
        if (std::isfinite(deviation))
            text += '"' + name.replace('"', "\"\"") + "\"," + number(angle_deg) + ',' + number(deviation) + '\n';
    };
    int position = 0;
    for (const report::PolarPlot::Trace& trace : plot.traces) {
        ++position;
        QString name = chartText(trace.name);
        if (name.isEmpty()) name = QString::number(position);
        const std::size_t count = std::min(trace.angle_deg.size(), trace.deviation_um.size());
        for (std::size_t i = 0; i < count; ++i) add(name, trace.angle_deg[i], trace.deviation_um[i]);
    }
    const report::PolarPlot::ReferenceLine* named = nullptr;
    for (const report::PolarPlot::ReferenceLine& circle : plot.circles) {
        ++position;
        QString name = chartText(circle.name);
        if (!name.isEmpty())
            named = &circle;
        else if (named)  // second circle of a zone, without a legend entry
            name = (circle.deviation_um < named->deviation_um ? PolarWords::tr("%1, inner circle")
                                                              : PolarWords::tr("%1, outer circle"))
                       .arg(chartText(named->name));
        else
            name = QString::number(position);
        for (int angle = 0; angle < 360; ++angle) add(name, angle, deviationAt(circle, plot.base_radius_mm, angle));
    }
    for (const report::PolarPlot::Mark& mark : plot.contacts)
        add(mark.outer ? PolarWords::tr("outer contact") : PolarWords::tr("inner contact"), mark.angle_deg,
            mark.deviation_um);
    return text;
}

}  // namespace lathelier::plot
