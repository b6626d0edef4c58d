#include "engine/report/map_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lathelier::report {
namespace {

constexpr int mostColumns = 900;
constexpr int mostImageRows = 450;
constexpr std::uint8_t nothingIndex = mapLevels;

double levelValue(const ColourMap& map, int level)
{
    return map.limit * (2.0 * level / (mapLevels - 1) - 1);
}

std::uint8_t indexOf(const ColourMap& map, double value)
{
    if (!std::isfinite(value)) return nothingIndex;
    const double share = std::clamp(0.5 * (value / map.limit + 1), 0.0, 1.0);
    int level = static_cast<int>(std::lround(share * (mapLevels - 1)));
    // Rounding to a level must not move values across the edge of the tolerance band.
    const auto isInside = [&](double v) { return map.tolerance && std::abs(v) <= *map.tolerance; };
    const int outward = value > 0 ? 1 : -1;
    while (!isInside(value) && isInside(levelValue(map, level)) && level > 0 && level < mapLevels - 1) level += outward;
    while (isInside(value) && !isInside(levelValue(map, level))) level -= outward;
    return static_cast<std::uint8_t>(level);
}

/// Mean of the finite cells in one block of the grid; NaN when there are none.
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

}  // namespace

std::vector<Rgb> paletteOf(const ColourMap& map)
{
    const DeviationColours colour = coloursOf(map);
    std::vector<Rgb> result;
    result.reserve(256);
    for (int level = 0; level < mapLevels; ++level) result.push_back(colour(levelValue(map, level)));
    result.push_back({255, 255, 255});
    return result;
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
    image.height = std::min(map.rows, mostImageRows);
    image.palette = paletteOf(map);
    image.transparent = nothingIndex;
    const auto edge = [](int i, int cells, int pixels) { return static_cast<int>(std::int64_t{i} * cells / pixels); };
    for (int row = image.height - 1; row >= 0; --row)  // y increases upwards
        for (int column = 0; column < image.width; ++column)
            image.pixels.push_back(indexOf(
                map, blockMean(map, edge(column, map.columns, image.width), edge(column + 1, map.columns, image.width),
                               edge(row, map.rows, image.height), edge(row + 1, map.rows, image.height))));
    return image;
}

}  // namespace lathelier::report
