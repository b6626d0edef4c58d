#include "engine/report/plot_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/report/map_image.h"
#include "engine/report/plot_paths.h"

namespace lathelier::report {
namespace {

constexpr double plotHeight = 330;
constexpr double halfSheetWidth = 520;
constexpr double halfSheetHeight = 280;
constexpr double halfMargin = 16;
constexpr int halfTicks = 6;
constexpr std::string_view limitDashes = "6 4";
constexpr std::string_view curveDashes = "7 4";
constexpr double bandOpacity = 0.3;
constexpr double barOpacity = 0.6;
constexpr double regionOpacity = 0.14;
constexpr double pointRadius = 2.5;
constexpr int groundColumns = 320;
constexpr int groundRows = 160;
constexpr double handleRadius = 6;

std::string limitColour()
{
    return hex(colourOf(ColourRole::Limit));
}

PlotFrame frameOf(const Plot& plot, const Language& language, Sheet sheet)
{
    PlotFrame frame;
    if (sheet == Sheet::Half) {
        frame.right = halfSheetWidth - halfMargin;
        frame.x_ticks = halfTicks;
    }
    frame.bottom = (sheet == Sheet::Half ? halfSheetHeight : plotHeight) - frameBottomRoom;
    frame.x = shownX(plot);
    frame.y = shownY(plot);
    frame.x_scale = plot.x.scale;
    frame.y_scale = plot.y.scale;
    frame.x_factor = shownUnit(plot.x.unit, language).factor;
    frame.y_factor = shownUnit(plot.y.unit, language).factor;
    if (!plot.equal_scales) return frame;
    // Extends the range of the axis with spare space, for equal scales.
    const auto widen = [](Interval& range, double length) {
        const double middle = (range.from + range.to) / 2;
        range = {middle - length / 2, middle + length / 2};
    };
    const double width = frame.x.to - frame.x.from, height = frame.y.to - frame.y.from;
    const double ratio = (frame.right - frame.left) / (frame.bottom - frame.top);
    if (width < ratio * height)
        widen(frame.x, ratio * height);
    else
        widen(frame.y, width / ratio);
    return frame;
}

/// The visible part of the background map, paler than a separate map.
void drawGround(Svg& svg, const PlotFrame& frame, const ColourMap& ground)
{
    ColourMap part = ground;
    part.columns = groundColumns;
    part.rows = groundRows;
    part.values.clear();
    part.values.reserve(static_cast<std::size_t>(groundColumns) * groundRows);
    const auto middle = [](const Interval& range, int i, int count) {
        return range.from + (range.to - range.from) * (i + 0.5) / count;
    };
    for (int row = 0; row < groundRows; ++row)
        for (int column = 0; column < groundColumns; ++column)
            part.values.push_back(static_cast<float>(
                ground.at(middle(frame.x, column, groundColumns), middle(frame.y, row, groundRows))));
    IndexedImage image = imageOf(part);
    const auto pale = [](std::uint8_t c) {
        return static_cast<std::uint8_t>(std::lround(255 - ColourMap::groundOpacity * (255 - c)));
    };
    for (Rgb& colour : image.palette) colour = {pale(colour.red), pale(colour.green), pale(colour.blue)};
    svg.png(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top, encodePng(image));
}

void drawCurve(Svg& svg, const PlotFrame& frame, const Curve& curve, const std::string& colour)
{
    const auto draw = [&](const std::string& data, std::string_view stroke, double width, std::string_view fill,
                          double opacity, std::string_view dashes = {}) {
        if (!data.empty()) svg.path(data, stroke, width, fill, opacity, dashes);
    };
    const double width = curve.thin ? 0.5 : 1.6;
    switch (curve.style) {
        case Curve::Style::Line: draw(linePath(frame, curve), colour, width, "none", 1); break;
        case Curve::Style::Dashed: draw(linePath(frame, curve), colour, width, "none", 1, curveDashes); break;
        case Curve::Style::Points:
            draw(pointsPath(frame, curve, curve.thin ? pointRadius / 2 : pointRadius), "none", 0, colour,
                 curve.thin ? 0.5 : 1);
            break;
        case Curve::Style::Band: draw(bandPath(frame, curve), "none", 0, colour, bandOpacity); break;
        case Curve::Style::Bars: draw(barsPath(frame, curve), "#ffffff", 0.5, colour, barOpacity); break;
    }
}

/// Labels drawn so far: left end, right end and baseline of each.
using Names = std::vector<std::array<double, 3>>;

/// A label beside its point, on the side with space, below labels it would overlap.
void drawName(Svg& svg, const PlotFrame& frame, double x, double y, const std::string& name, Names& names)
{
    if (name.empty()) return;
    constexpr int mostRows = 6;
    const double width = textWidth(name, tickSize);
    const bool fits = x + 5 + width <= frame.right;
    const double left = fits ? x + 5 : x - 5 - width;
    y = std::max(y, frame.top + tickSize);
    const auto covers = [&](const std::array<double, 3>& other) {
        return other[0] < left + width && other[1] > left && std::abs(other[2] - y) < tickSize;
    };
    for (int row = 0; row < mostRows && std::any_of(names.begin(), names.end(), covers); ++row) y += tickSize + 1;
    names.push_back({left, left + width, y});
    svg.text(fits ? x + 5 : x - 5, y, fits ? Svg::Anchor::Start : Svg::Anchor::End, tickSize, name);
}

void drawUpright(Svg& svg, const PlotFrame& frame, double place, const std::string& name, std::string_view dashes,
                 Names& names)
{
    const double x = frame.toX(place);
    if (!(x >= frame.left && x <= frame.right)) return;
    svg.line(x, frame.top, x, frame.bottom, limitColour(), 1.2, dashes);
    drawName(svg, frame, x, frame.top + tickSize + 1, name, names);
}

void drawLevel(Svg& svg, const PlotFrame& frame, double place, const std::string& name, std::string_view dashes)
{
    const double y = frame.toY(place);
    if (!(y >= frame.top && y <= frame.bottom)) return;
    svg.line(frame.left, y, frame.right, y, limitColour(), 1.2, dashes);
    if (!name.empty()) svg.text(frame.right - 4, y - 4, Svg::Anchor::End, tickSize, name);
}

void drawHandle(Svg& svg, const PlotFrame& frame, const Handle& handle, const std::string& name, Names& names)
{
    if (handle.kind == Handle::Kind::Vertical) return drawUpright(svg, frame, handle.x, name, limitDashes, names);
    if (handle.kind == Handle::Kind::Horizontal) return drawLevel(svg, frame, handle.y, name, limitDashes);
    const double x = frame.toX(handle.x), y = frame.toY(handle.y);
    if (!(x >= frame.left && x <= frame.right && y >= frame.top && y <= frame.bottom)) return;
    svg.path(discPath(x, y, handleRadius), limitColour(), 2, "#ffffff", 0.6);
    svg.path(discPath(x, y, 1.5), "none", 0, limitColour());
    drawName(svg, frame, x + handleRadius - 2, y - handleRadius, name, names);
}

/// One row at the right of the title, from right to left.
class PlotLegend {
public:
    PlotLegend(Svg& svg, const PlotFrame& frame) : svg_(svg), right_(frame.right), y_(frame.top - 13) {}

    static double widthOf(const std::string& name) { return textWidth(name, tickSize) + sampleWidth + 26; }

    /// Reserves space for `name`, draws it and returns the start of its sample line.
    double place(const std::string& name)
    {
        const double start = right_ - widthOf(name) + 20;
        svg_.text(start + sampleWidth + 6, y_ + 4, Svg::Anchor::Start, tickSize, name);
        right_ = start - 20;
        return start;
    }

    void addLine(const std::string& name, std::string_view colour, double width, std::string_view dashes = {})
    {
        const double start = place(name);
        svg_.line(start, y_, start + sampleWidth, y_, colour, width, dashes);
    }

    void addPoint(const std::string& name, std::string_view colour)
    {
        svg_.path(discPath(place(name) + sampleWidth / 2, y_, pointRadius), "none", 0, colour);
    }

    void addArea(const std::string& name, std::string_view colour, double opacity)
    {
        const std::string start = coordinate(place(name));
        svg_.path("M" + start + " " + coordinate(y_ - 5) + "h24v10h-24Z", "none", 0, colour, opacity);
    }

private:
    static constexpr double sampleWidth = 24;
    Svg& svg_;
    double right_;
    double y_;
};

/// On a half sheet left out where the names do not fit beside each other.
void drawPlotLegend(Svg& svg, const PlotFrame& frame, const Plot& plot, const Language& language, Sheet sheet)
{
    PlotLegend legend(svg, frame);
    double needed_px = 0;
    const auto count = [&](const Caption& caption) {
        if (const std::string name = captionText(caption, language); !name.empty()) needed_px += legend.widthOf(name);
    };
    for (const Region& region : plot.regions) count(region.name);
    for (const Curve& curve : plot.curves) count(curve.name);
    if (sheet == Sheet::Half && needed_px > frame.right) return;
    for (std::size_t i = plot.regions.size(); i-- > 0;) {
        const std::string name = captionText(plot.regions[i].name, language);
        if (!name.empty()) legend.addArea(name, hex(colourOf(plot.regions[i].colour, i)), regionOpacity);
    }
    for (std::size_t i = plot.curves.size(); i-- > 0;) {
        const std::string name = captionText(plot.curves[i].name, language);
        if (name.empty()) continue;
        const std::string colour = hex(colourOf(plot.curves[i].colour, i));
        switch (plot.curves[i].style) {
            case Curve::Style::Line: legend.addLine(name, colour, 2.5); break;
            case Curve::Style::Dashed: legend.addLine(name, colour, 2.5, curveDashes); break;
            case Curve::Style::Points: legend.addPoint(name, colour); break;
            case Curve::Style::Band: legend.addArea(name, colour, bandOpacity); break;
            case Curve::Style::Bars: legend.addArea(name, colour, barOpacity); break;
        }
    }
}

}  // namespace

std::string toSvg(const Plot& plot, const Language& language, Sheet sheet)
{
    const auto words = [&](const Caption& caption) { return captionText(caption, language); };
    const bool is_half = sheet == Sheet::Half;
    const std::string title = words(plot.title);
    const FrameWords titles{is_half ? std::string() : title, is_half ? std::string() : words(plot.remark),
                            axisLabel(plot.x, language), axisLabel(plot.y, language)};
    Svg svg(is_half ? halfSheetWidth : sheetWidth, is_half ? halfSheetHeight : plotHeight, title);
    const PlotFrame frame = frameOf(plot, language, sheet);
    if (plot.ground && isDrawable(*plot.ground)) drawGround(svg, frame, *plot.ground);
    for (std::size_t i = 0; i < plot.regions.size(); ++i) {
        const std::string data = regionPath(frame, plot.regions[i]);
        if (!data.empty()) svg.path(data, "none", 0, hex(colourOf(plot.regions[i].colour, i)), regionOpacity);
    }
    drawFrame(svg, frame, titles, language, true);
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        drawCurve(svg, frame, plot.curves[i], hex(colourOf(plot.curves[i].colour, i)));
    Names names;
    for (const Limit& limit : plot.limits) {
        if (limit.direction == Limit::Direction::Vertical)
            drawUpright(svg, frame, limit.place, words(limit.name), limitDashes, names);
        else
            drawLevel(svg, frame, limit.place, words(limit.name), limitDashes);
    }
    for (const Mark& mark : plot.marks) {
        const double x = frame.toX(mark.x), y = frame.toY(mark.y);
        if (!(x >= frame.left && x <= frame.right && y >= frame.top && y <= frame.bottom)) continue;
        svg.path(discPath(x, y, 3.5), "#ffffff", 1, hex(colourOf(ColourRole::Mark)));
        drawName(svg, frame, x, y - 6, words(mark.name), names);
    }
    for (const Handle& handle : plot.handles) drawHandle(svg, frame, handle, words(handle.name), names);
    drawOutline(svg, frame);
    drawPlotLegend(svg, frame, plot, language, sheet);
    return svg.finish();
}

}  // namespace lathelier::report
