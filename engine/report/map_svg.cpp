#include <algorithm>
#include <cmath>

#include "engine/report/colours.h"
#include "engine/report/plot_frame.h"
#include "engine/report/plot_svg.h"
#include "engine/report/png.h"

namespace lathelier::report {
namespace {

constexpr double mapHeight = 350;
constexpr double bottomRoom = 52;
constexpr int mostColumns = 900;
constexpr int mostRows = 450;

constexpr int levels = 255;  ///< of the scale, an odd number so that 0 is one; with "nothing there" the palette is full
constexpr std::uint8_t nothingIndex = levels;

double levelValue(const ColourMap& map, int level)
{
    return map.limit * (2.0 * level / (levels - 1) - 1);
}

std::uint8_t indexOf(const ColourMap& map, double value)
{
    if (!std::isfinite(value)) return nothingIndex;
    const double share = std::clamp(0.5 * (value / map.limit + 1), 0.0, 1.0);
    int level = static_cast<int>(std::lround(share * (levels - 1)));
    // Rounding to a level must turn neither "just outside" into the colour of "inside" nor the other way round.
    const auto isInside = [&](double v) { return map.tolerance && std::abs(v) <= *map.tolerance; };
    const int outward = value > 0 ? 1 : -1;
    while (!isInside(value) && isInside(levelValue(map, level)) && level > 0 && level < levels - 1) level += outward;
    while (isInside(value) && !isInside(levelValue(map, level))) level -= outward;
    return static_cast<std::uint8_t>(level);
}

std::vector<Rgb> paletteOf(const ColourMap& map)
{
    const DeviationColours colour{map.limit, map.tolerance, map.steps, map.marked};
    std::vector<Rgb> result;
    result.reserve(256);
    for (int level = 0; level < levels; ++level) result.push_back(colour(levelValue(map, level)));
    result.push_back({255, 255, 255});
    return result;
}

/// The mean of the cells there are in one block of the grid; NaN when there are none.
double blockMean(const ColourMap& map, int column0, int column1, int row0, int row1)
{
    double sum = 0;
    int count = 0;
    for (int row = row0; row < row1; ++row)
        for (int column = column0; column < column1; ++column) {
            const float value = map.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                                           static_cast<std::size_t>(column)];
            if (!std::isfinite(value)) continue;
            sum += value;
            ++count;
        }
    return count > 0 ? sum / count : NAN;
}

bool isDrawable(const ColourMap& map)
{
    return map.columns > 0 && map.rows > 0 && map.limit > 0 && map.x_from < map.x_to && map.y_from < map.y_to &&
           map.values.size() == static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
}

IndexedImage imageOf(const ColourMap& map)
{
    IndexedImage image;
    image.width = std::min(map.columns, mostColumns);
    image.height = std::min(map.rows, mostRows);
    image.palette = paletteOf(map);
    image.transparent = nothingIndex;
    const auto edge = [](int i, int cells, int pixels) { return static_cast<int>(std::int64_t{i} * cells / pixels); };
    for (int row = image.height - 1; row >= 0; --row)  // y grows upward
        for (int column = 0; column < image.width; ++column)
            image.pixels.push_back(indexOf(
                map, blockMean(map, edge(column, map.columns, image.width), edge(column + 1, map.columns, image.width),
                               edge(row, map.rows, image.height), edge(row + 1, map.rows, image.height))));
    return image;
}

/// The colour bar at the right, with its own ticks; the tolerance is marked on it.
void drawScale(Svg& svg, const PlotFrame& frame, const ColourMap& map, const std::string& title,
               const Language& language)
{
    const double left = frame.right + 18;
    const double width = 16;
    IndexedImage bar;
    bar.width = 1;
    bar.height = levels;
    bar.palette = paletteOf(map);
    for (int level = levels - 1; level >= 0; --level) bar.pixels.push_back(indexOf(map, levelValue(map, level)));
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
    frame.bottom = mapHeight - bottomRoom;
    frame.x = isDrawable(map) ? Interval{map.x_from, map.x_to} : Interval{0, 1};
    frame.y = isDrawable(map) ? Interval{map.y_from, map.y_to} : Interval{0, 1};
    frame.x_factor = shownUnit(map.x.unit, language).factor;
    frame.y_factor = shownUnit(map.y.unit, language).factor;
    if (isDrawable(map)) {
        svg.png(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top, encodePng(imageOf(map)));
        drawScale(svg, frame, map, axisLabel(map.value, language), language);
    }
    drawFrame(svg, frame, {title, {}, axisLabel(map.x, language), axisLabel(map.y, language)}, language, false);
    drawOutline(svg, frame);
    return svg.finish();
}

}  // namespace lathelier::report
