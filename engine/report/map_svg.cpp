#include <algorithm>
#include <cmath>

#include "engine/report/map_image.h"
#include "engine/report/plot_frame.h"
#include "engine/report/plot_svg.h"
#include "engine/report/png.h"

namespace lathelier::report {
namespace {

constexpr double mapHeight = 350;

/// The colour bar at the right, with its own ticks; the tolerance is marked on it.
void drawColourScale(Svg& svg, const PlotFrame& frame, const ColourMap& map, const std::string& title,
                     const Language& language)
{
    const double left = frame.right + 18;
    const double width = 16;
    IndexedImage bar;
    bar.width = 1;
    bar.height = mapLevels;
    bar.palette = paletteOf(map);
    for (int level = mapLevels - 1; level >= 0; --level) bar.pixels.push_back(static_cast<std::uint8_t>(level));
    svg.png(left, frame.top, width, frame.bottom - frame.top, encodePng(bar));
    svg.rect(left, frame.top, width, frame.bottom - frame.top, "none", "#7b8794");
    PlotFrame scale = frame;
    scale.y = {-map.limit, map.limit};
    const Ticks ticks = axisTicks(Axis::Scale::Linear, scale.y, 6, shownUnit(map.value.unit, language).factor);
    for (const double value : ticks.values) {
        svg.line(left + width, scale.toY(value), left + width + 4, scale.toY(value), "#7b8794");
        std::string label = tickLabel(value, ticks, language);
        if (value > 0) label.insert(0, 1, '+');
        svg.text(left + width + 7, scale.toY(value) + 4, Svg::Anchor::Start, tickSize, label);
    }
    svg.text(sheetWidth - 4, frame.top - 10, Svg::Anchor::End, tickSize, title);
}

}  // namespace

std::string toSvg(const ColourMap& map, const Language& language)
{
    const std::string title = captionText(map.title, language);
    Svg svg(sheetWidth, mapHeight, title);
    PlotFrame frame;
    frame.bottom = mapHeight - frameBottomRoom;
    frame.x = isDrawable(map) ? Interval{map.x_from, map.x_to} : Interval{0, 1};
    frame.y = isDrawable(map) ? Interval{map.y_from, map.y_to} : Interval{0, 1};
    frame.x_factor = shownUnit(map.x.unit, language).factor;
    frame.y_factor = shownUnit(map.y.unit, language).factor;
    if (isDrawable(map)) {
        svg.png(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top, encodePng(imageOf(map)));
        drawColourScale(svg, frame, map, axisLabel(map.value, language), language);
    }
    drawFrame(svg, frame, {title, {}, axisLabel(map.x, language), axisLabel(map.y, language)}, language, false);
    drawOutline(svg, frame);
    return svg.finish();
}

}  // namespace lathelier::report
