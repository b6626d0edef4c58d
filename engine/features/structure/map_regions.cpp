#include "engine/features/structure/map_regions.h"

#include <algorithm>

namespace lathelier::features {

std::vector<std::vector<std::size_t>> connectedRegions(const std::vector<std::uint8_t>& taken, std::size_t columns,
                                                       bool closed)
{
    std::vector<std::uint8_t> seen(taken.size(), 0);
    std::vector<std::vector<std::size_t>> regions;
    for (std::size_t seed = 0; seed < taken.size(); ++seed) {
        if (!taken[seed] || seen[seed]) continue;
        std::vector<std::size_t>& region = regions.emplace_back(1, seed);
        seen[seed] = 1;
        const auto add = [&](std::size_t cell) {
            if (!taken[cell] || seen[cell]) return;
            seen[cell] = 1;
            region.push_back(cell);
        };
        for (std::size_t next = 0; next < region.size(); ++next) {
            const std::size_t cell = region[next], column = cell % columns, begin = cell - column;
            if (column + 1 < columns || closed) add(begin + (column + 1) % columns);
            if (column > 0 || closed) add(begin + (column + columns - 1) % columns);
            if (cell + columns < taken.size()) add(cell + columns);
            if (cell >= columns) add(cell - columns);
        }
        std::sort(region.begin(), region.end());
    }
    return regions;
}

RegionBox boxOf(const std::vector<std::size_t>& region, std::size_t columns, bool closed)
{
    RegionBox box;
    box.first_row = region.front() / columns;
    box.last_row = region.back() / columns;
    std::vector<std::uint8_t> used(columns, 0);
    for (const std::size_t cell : region) used[cell % columns] = 1;
    const auto first = std::find(used.begin(), used.end(), 1);
    box.first_column = static_cast<std::size_t>(first - used.begin());
    box.last_column = static_cast<std::size_t>(used.rend() - std::find(used.rbegin(), used.rend(), 1)) - 1;
    if (!closed) return box;
    // The longest stretch of columns without a cell lies outside the box.
    std::size_t longest = 0, run = 0, after = box.first_column;
    for (std::size_t i = 0; i < 2 * columns; ++i) {
        run = used[i % columns] ? 0 : run + 1;
        if (run <= longest || run > columns) continue;
        longest = run;
        after = (i + 1) % columns;
    }
    box.first_column = longest > 0 ? after : 0;
    box.last_column = box.first_column + columns - longest - 1;
    return box;
}

bool isRound(const std::vector<std::size_t>& region, const RegionBox& box, double row_mm, double column_mm,
             double most_aspect, double most_fill)
{
    constexpr std::size_t judged = 6;  // a circle over fewer rows or columns may fill its corners
    const double length = row_mm * static_cast<double>(box.rows()),
                 width = column_mm * static_cast<double>(box.columns());
    if (length > most_aspect * width || width > most_aspect * length) return false;
    const double box_cells = static_cast<double>(box.rows()) * static_cast<double>(box.columns());
    return std::min(box.rows(), box.columns()) < judged || static_cast<double>(region.size()) < most_fill * box_cells;
}

}  // namespace lathelier::features
