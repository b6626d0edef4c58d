#include "engine/report/plot_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/report/plot_frame.h"

namespace lathelier {
namespace {

constexpr double plotHeight = 330;
constexpr double bottomRoom = 52;
constexpr std::string_view markColour = "#52606d";
constexpr std::string_view markDashes = "6 4";
constexpr double bandOpacity = 0.18;
constexpr double barOpacity = 0.8;

std::string_view colourOf(const Curve& curve, std::size_t position)
{
    return plotColour(curve.colour >= 0 ? static_cast<std::size_t>(curve.colour) : position);
}

/// The points a curve can be drawn from.
std::size_t length(const Curve& curve)
{
    if (curve.style == Curve::Style::Bars) return std::min(curve.y.size(), curve.x.empty() ? 0 : curve.x.size() - 1);
    std::size_t count = std::min(curve.x.size(), curve.y.size());
    if (curve.style == Curve::Style::Band) count = std::min(count, curve.y_low.size());
    return count;
}

PlotFrame frameOf(const Plot& plot)
{
    Extent x;
    Extent y;
    for (const Curve& curve : plot.curves) {
        const std::size_t count = length(curve);
        const bool bars = curve.style == Curve::Style::Bars;
        for (std::size_t i = 0; i < count + (bars && count > 0 ? 1 : 0); ++i) x.add(curve.x[i]);
        for (std::size_t i = 0; i < count; ++i) y.add(curve.y[i]);
        if (curve.style == Curve::Style::Band)
            for (std::size_t i = 0; i < count; ++i) y.add(curve.y_low[i]);
        if (bars) y.add(0);
    }
    for (const double mark : plot.y_marks) y.add(mark);
    for (const double mark : plot.x_marks) x.add(mark);
    PlotFrame frame;
    frame.bottom = plotHeight - bottomRoom;
    frame.x = x.interval();
    if (plot.x_range && plot.x_range->from < plot.x_range->to) frame.x = *plot.x_range;
    const Interval all = y.interval();
    const double air = 0.05 * (all.to - all.from);
    frame.y = {all.from == 0 ? 0 : all.from - air, all.to + air};
    if (plot.y_range && plot.y_range->from < plot.y_range->to) frame.y = *plot.y_range;
    return frame;
}

struct SheetPoint {
    double x;
    double y;
};

/// One unbroken stretch of a curve.
using Stretch = std::vector<SheetPoint>;

std::vector<Stretch> stretches(const PlotFrame& frame, const std::vector<double>& x, const std::vector<double>& y)
{
    std::vector<Stretch> result;
    bool open = false;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        if (!isDrawable(x[i]) || !isDrawable(y[i])) {
            open = false;
            continue;
        }
        if (!open) result.emplace_back();
        open = true;
        result.back().push_back({frame.toX(x[i]), std::clamp(frame.toY(y[i]), frame.top, frame.bottom)});
    }
    return result;
}

/// Keeps the first, lowest, highest and last of the points that follow each other in one column of pixels.
Stretch thinned(const Stretch& points)
{
    Stretch result;
    for (std::size_t begin = 0; begin < points.size();) {
        const double column = std::floor(points[begin].x);
        std::size_t low = begin;
        std::size_t high = begin;
        std::size_t end = begin;
        for (; end < points.size() && std::floor(points[end].x) == column; ++end) {
            if (points[end].y < points[low].y) low = end;
            if (points[end].y > points[high].y) high = end;
        }
        std::array<std::size_t, 4> kept{begin, std::min(low, high), std::max(low, high), end - 1};
        for (std::size_t k = 0; k < kept.size(); ++k)
            if (k == 0 || kept[k] != kept[k - 1]) result.push_back(points[kept[k]]);
        begin = end;
    }
    return result;
}

std::string moves(const Stretch& points, char first = 'M')
{
    std::string data;
    for (const SheetPoint& point : points) {
        data += data.empty() ? first : 'L';
        data += coordinate(point.x) + " " + coordinate(point.y);
    }
    return data;
}

void drawLine(Svg& svg, const PlotFrame& frame, const Curve& curve, std::string_view colour)
{
    std::string data;
    for (const Stretch& stretch : stretches(frame, curve.x, curve.y)) {
        data += moves(thinned(stretch));
        if (stretch.size() == 1) data += "h0.01";  // a lone point shows as a dot
    }
    if (!data.empty()) svg.path(data, colour, 1.6);
}

void drawBand(Svg& svg, const PlotFrame& frame, const Curve& curve, std::string_view colour)
{
    // Both edges break together, so that they pair up again after a gap.
    std::vector<double> high = curve.y;
    std::vector<double> low = curve.y_low;
    for (std::size_t i = 0; i < std::min(high.size(), low.size()); ++i)
        if (!isDrawable(high[i]) || !isDrawable(low[i])) high[i] = low[i] = NAN;
    const std::vector<Stretch> above = stretches(frame, curve.x, high);
    const std::vector<Stretch> below = stretches(frame, curve.x, low);
    std::string data;
    for (std::size_t i = 0; i < std::min(above.size(), below.size()); ++i) {
        Stretch back = thinned(below[i]);
        std::reverse(back.begin(), back.end());
        data += moves(thinned(above[i])) + moves(back, 'L') + "Z";
    }
    if (!data.empty()) svg.path(data, "none", 0, colour, bandOpacity);
}

void drawBars(Svg& svg, const PlotFrame& frame, const Curve& curve, std::string_view colour)
{
    std::string data;
    const double base = std::clamp(frame.toY(0), frame.top, frame.bottom);
    for (std::size_t i = 0; i < length(curve); ++i) {
        if (!isDrawable(curve.x[i]) || !isDrawable(curve.x[i + 1]) || !isDrawable(curve.y[i]) || curve.y[i] == 0)
            continue;
        const double left = frame.toX(curve.x[i]);
        const double right = frame.toX(curve.x[i + 1]);
        const double top = std::clamp(frame.toY(curve.y[i]), frame.top, frame.bottom);
        data += fmt::format("M{} {}V{}H{}V{}Z", coordinate(left), coordinate(base), coordinate(top), coordinate(right),
                            coordinate(base));
    }
    if (!data.empty()) svg.path(data, "#ffffff", 0.5, colour, barOpacity);
}

/// One row at the right of the title, from right to left.
class Legend {
public:
    Legend(Svg& svg, const PlotFrame& frame) : svg_(svg), right_(frame.right), y_(frame.top - 13) {}

    /// Makes room for `name`; draws it and hands out where its sample starts.
    double place(const std::string& name)
    {
        const double start = right_ - textWidth(name, tickSize) - sampleWidth - 6;
        svg_.text(start + sampleWidth + 6, y_ + 4, Svg::Anchor::Start, tickSize, name);
        right_ = start - 20;
        return start;
    }

    void addLine(const std::string& name, std::string_view colour, double width, std::string_view dashes = {})
    {
        const double start = place(name);
        svg_.line(start, y_, start + sampleWidth, y_, colour, width, dashes);
    }

    void addArea(const std::string& name, std::string_view colour, double opacity)
    {
        const double start = place(name);
        svg_.path(fmt::format("M{} {}h24v10h-24Z", coordinate(start), coordinate(y_ - 5)), "none", 0, colour, opacity);
    }

private:
    static constexpr double sampleWidth = 24;
    Svg& svg_;
    double right_;
    double y_;
};

void drawLegend(Svg& svg, const PlotFrame& frame, const Plot& plot, const Language& language)
{
    Legend legend(svg, frame);
    const std::string marks = captionText(plot.marks_name, language);
    if (!marks.empty() && !(plot.x_marks.empty() && plot.y_marks.empty()))
        legend.addLine(marks, markColour, 1.2, markDashes);
    for (std::size_t i = plot.curves.size(); i-- > 0;) {
        const std::string name = captionText(plot.curves[i].name, language);
        if (name.empty()) continue;
        const std::string_view colour = colourOf(plot.curves[i], i);
        switch (plot.curves[i].style) {
            case Curve::Style::Line: legend.addLine(name, colour, 2.5); break;
            case Curve::Style::Band: legend.addArea(name, colour, bandOpacity); break;
            case Curve::Style::Bars: legend.addArea(name, colour, barOpacity); break;
        }
    }
}

}  // namespace

std::string toSvg(const Plot& plot, const Language& language)
{
    const std::string title = captionText(plot.title, language);
    Svg svg(sheetWidth, plotHeight, title);
    const PlotFrame frame = frameOf(plot);
    drawFrame(svg, frame, title, captionText(plot.x_title, language), captionText(plot.y_title, language), language,
              true);
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const Curve& curve = plot.curves[i];
        switch (curve.style) {
            case Curve::Style::Line: drawLine(svg, frame, curve, colourOf(curve, i)); break;
            case Curve::Style::Band: drawBand(svg, frame, curve, colourOf(curve, i)); break;
            case Curve::Style::Bars: drawBars(svg, frame, curve, colourOf(curve, i)); break;
        }
    }
    for (const double mark : plot.y_marks)
        if (const double y = frame.toY(mark); y >= frame.top && y <= frame.bottom)
            svg.line(frame.left, y, frame.right, y, markColour, 1.2, markDashes);
    for (const double mark : plot.x_marks)
        if (const double x = frame.toX(mark); x >= frame.left && x <= frame.right)
            svg.line(x, frame.top, x, frame.bottom, markColour, 1.2, markDashes);
    drawOutline(svg, frame);
    drawLegend(svg, frame, plot, language);
    return svg.finish();
}

}  // namespace lathelier
