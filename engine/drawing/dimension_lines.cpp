#include "engine/drawing/dimension_lines.h"

#include <algorithm>
#include <cmath>

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double contourOffset_mm = 1;      // between a contour and its extension line
constexpr double extensionOverhang_mm = 1;  // of an extension line beyond the dimension line
constexpr double arrowTail_mm = 2;          // of a dimension line beyond arrows that stand outside

}  // namespace

void DimensionPainter::line(const Vector2d& from, const Vector2d& to, Layer layer)
{
    drawing_.lines.push_back({from, to, layer, thin_mm});
}

void DimensionPainter::arrow(const Vector2d& tip, const Vector2d& direction)
{
    drawing_.arrows.push_back({tip, direction.normalized(), arrow_mm});
}

void DimensionPainter::text(const Vector2d& at, const DimensionText& text, Anchor anchor, double angle_deg)
{
    drawing_.labels.push_back(
        {at, height_mm_, angle_deg, text.text, anchor, text.italic, Layer::Dimensions, text.target});
}

bool DimensionPainter::fitsInside(double length_mm, const DimensionText& label) const
{
    return length_mm >= widthOf(label) + 1;
}

std::pair<double, double> DimensionPainter::extentOf(double from_x, double to_x, const DimensionText& label) const
{
    const double length = to_x - from_x;
    const bool arrows_inside = length >= 2 * arrow_mm + 1;
    const double tail = arrows_inside ? 0 : arrow_mm + arrowTail_mm;
    if (fitsInside(length, label)) return {from_x - tail, to_x + tail};
    const double text_end = from_x - (arrows_inside ? 1 : arrow_mm + 1);
    return {text_end - widthOf(label), to_x + tail};
}

void DimensionPainter::horizontal(double from_x, double to_x, double y, double from_y, double to_y,
                                  const DimensionText& label, std::optional<double> text_x)
{
    const double sense = to_x < from_x ? -1 : 1, length = std::abs(to_x - from_x);
    for (const auto& [x, start] : {std::pair(from_x, from_y), std::pair(to_x, to_y)}) {
        const double away = y < start ? -1 : 1;
        line({x, start + away * contourOffset_mm}, {x, y + away * extensionOverhang_mm});
    }
    const bool arrows_inside = length >= 2 * arrow_mm + 1;
    const Vector2d along(sense, 0);
    arrow({from_x, y}, arrows_inside ? Vector2d(-along) : along);
    arrow({to_x, y}, arrows_inside ? along : Vector2d(-along));
    double start = from_x, end = to_x;
    if (!arrows_inside) {
        start -= sense * (arrow_mm + arrowTail_mm);
        end += sense * (arrow_mm + arrowTail_mm);
    }
    if (fitsInside(length, label) && text_x != outside) {
        text({text_x.value_or((from_x + to_x) / 2), y + gap_mm()}, label, Anchor::Middle);
    } else {
        const double near = from_x - sense * (arrows_inside ? 1 : arrow_mm + 1);
        start = near - sense * widthOf(label);
        text({near, y + gap_mm()}, label, sense > 0 ? Anchor::End : Anchor::Start);
    }
    line({start, y}, {end, y});
}

void DimensionPainter::vertical(double x, double from_y, double to_y, const DimensionText& label)
{
    const double low = std::min(from_y, to_y), high = std::max(from_y, to_y), length = high - low;
    const bool arrows_inside = length >= 2 * arrow_mm + 1;
    arrow({x, low}, Vector2d(0, arrows_inside ? -1 : 1));
    arrow({x, high}, Vector2d(0, arrows_inside ? 1 : -1));
    double top = arrows_inside ? high : high + arrow_mm + arrowTail_mm;
    const double bottom = arrows_inside ? low : low - arrow_mm - arrowTail_mm;
    if (fitsInside(length, label)) {
        text({x - gap_mm(), (low + high) / 2}, label, Anchor::Middle, 90);
    } else {
        const double begin = high + (arrows_inside ? 1 : arrow_mm + 1);
        text({x - gap_mm(), begin}, label, Anchor::Start, 90);
        top = begin + widthOf(label);
    }
    line({x, bottom}, {x, top});
}

}  // namespace lathelier::drawing
