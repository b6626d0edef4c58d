#include "engine/drawing/difference_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/drawing/title_block.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double rowHeight_mm = 3.4, letterHeight_mm = 1.7, padding_mm = 0.8;
constexpr std::array cellWidths_mm{5.0, 31.0, 24.0, 27.0};  // number, size, measured, difference
constexpr std::size_t cellCount = cellWidths_mm.size();

double columnWidth_mm()
{
    double sum = 0;
    for (const double width : cellWidths_mm) sum += width;
    return sum;
}

/// Where the table may stand, and how many rows high it is at least before a further column begins.
struct Place {
    double left_mm = 0, bottom_mm = 0;
    std::size_t columns = 1;
};

Place placeOf(Sheet sheet, double block_height_mm)
{
    const Box frame = frameBox(sheet);
    const auto beside = static_cast<std::size_t>((frame.width_mm() - titleBlockWidth_mm) / columnWidth_mm());
    if (beside > 0) return {frame.left_mm, frame.bottom_mm, beside};
    const auto above = static_cast<std::size_t>(frame.width_mm() / columnWidth_mm());
    return {frame.left_mm, frame.bottom_mm + block_height_mm, std::max<std::size_t>(1, above)};
}

class TablePainter {
public:
    TablePainter(const std::vector<Difference>& differences, const DrawingOptions& options, const Place& place,
                 std::size_t rows)
        : options_(options)
    {
        for (std::size_t first = 0, column = 0; first < differences.size(); first += rows, ++column) {
            const std::size_t count = std::min(rows, differences.size() - first);
            const double left = place.left_mm + static_cast<double>(column) * columnWidth_mm();
            addColumn(differences, first, count, left, place.bottom_mm);
        }
    }

    Drawing take() { return std::move(drawing_); }

private:
    void line(const Vector2d& from, const Vector2d& to, double width_mm)
    {
        drawing_.lines.push_back({from, to, Layer::Frame, width_mm});
    }

    void addColumn(const std::vector<Difference>& differences, std::size_t first, std::size_t count, double left,
                   double bottom)
    {
        const double top = bottom + static_cast<double>(count + 1) * rowHeight_mm, right = left + columnWidth_mm();
        for (const double x : {left, right}) line({x, bottom}, {x, top}, thick_mm);
        for (const double y : {bottom, top}) line({left, y}, {right, y}, thick_mm);
        double x = left;
        for (std::size_t i = 0; i + 1 < cellCount; ++i) {
            x += cellWidths_mm[i];
            line({x, bottom}, {x, top}, thin_mm);
        }
        addRow(top, left,
               {std::string("n"), translated(LT_TEXT("Engine", "Size"), options_),
                translated(LT_TEXT("Engine", "Measured"), options_),
                translated(LT_TEXT("Engine", "Measured − nominal"), options_)},
               false);
        for (std::size_t i = 0; i < count; ++i) {
            const double y = top - static_cast<double>(i + 1) * rowHeight_mm;
            line({left, y}, {right, y}, thin_mm);
            addRow(y, left, cellsOf(first + i + 1, differences[first + i]), true);
        }
    }

    std::array<std::string, cellCount> cellsOf(std::size_t number, const Difference& one) const
    {
        const double off = one.measured_mm - one.nominal_mm;
        std::string difference = fmt::format("{:+.3f}", std::abs(off) < 5e-4 ? 0 : off);
        if (std::abs(off) < 5e-4) difference = fmt::format("{:+.4f}", off);
        for (const auto& [from, to] : {std::pair<std::string, std::string>("-", "−"),
                                       std::pair<std::string, std::string>(".", options_.decimal_separator)})
            if (const std::size_t at = difference.find(from); at != std::string::npos)
                difference.replace(at, from.size(), to);
        return {std::to_string(number), one.size, measuredSize(one.measured_mm, one.U_um, options_.decimal_separator),
                difference};
    }

    void addRow(double top, double left, const std::array<std::string, cellCount>& cells, bool measured)
    {
        for (std::size_t i = 0; i < cellCount; ++i) {
            Label label{{left + padding_mm, top - rowHeight_mm + 0.9}, letterHeight_mm};
            label.text = cells[i];
            label.italic = measured && i == 2;
            fitInto(label, cellWidths_mm[i] - 2 * padding_mm);
            drawing_.labels.push_back(label);
            left += cellWidths_mm[i];
        }
    }

    const DrawingOptions& options_;
    Drawing drawing_;
};

}  // namespace

Drawing differenceTable(const std::vector<Difference>& differences, const DrawingOptions& options, Sheet sheet,
                        double block_height_mm)
{
    if (differences.empty()) return {};
    const Place place = placeOf(sheet, block_height_mm);
    const auto as_high = static_cast<std::size_t>(std::max(1.0, block_height_mm / rowHeight_mm - 1));
    const std::size_t even = (differences.size() + place.columns - 1) / place.columns;
    const bool above = place.bottom_mm > frameBox(sheet).bottom_mm + 1e-6;
    return TablePainter(differences, options, place,
                        above ? even : std::max(even, std::min(as_high, differences.size())))
        .take();
}

}  // namespace lathelier::drawing
