#include "engine/drawing/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/core/utf8.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

/// Advance widths of DejaVu Sans for U+0020 to U+007E, thousandths of the font size.
constexpr std::array<int, 95> asciiWidths = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr int otherCharacterWidth = 700;  // upper bound for letters with accents and other scripts
constexpr double descentShare = 0.32;     // depth below the base line over the height
constexpr double ascentShare = 1.15;      // height above the base line over the height

/// Advance widths of the signs of drawings.
constexpr std::array<std::pair<char32_t, int>, 7> signWidths = {{
    {0xB0, 500},     // °
    {0xB1, 838},     // ±
    {0xD7, 838},     // ×
    {0x2212, 838},   // minus
    {0x2300, 787},   // ⌀, set as Ø
    {0x25B7, 769},   // ▷
    {0x2026, 1000},  // …
}};

int advanceOf(char32_t code)
{
    if (code >= 0x20 && code <= 0x7E) return asciiWidths.at(code - 0x20);
    for (const auto& [sign, advance] : signWidths)
        if (sign == code) return advance;
    return code > 0x2000 ? 1000 : otherCharacterWidth;
}

void grow(Box& box, const Vector2d& point)
{
    box.left_mm = std::min(box.left_mm, point.x());
    box.right_mm = std::max(box.right_mm, point.x());
    box.bottom_mm = std::min(box.bottom_mm, point.y());
    box.top_mm = std::max(box.top_mm, point.y());
}

}  // namespace

bool Box::overlaps(const Box& other) const
{
    return left_mm < other.right_mm && other.left_mm < right_mm && bottom_mm < other.top_mm && other.bottom_mm < top_mm;
}

bool Box::contains(const Box& other) const
{
    return left_mm <= other.left_mm && other.right_mm <= right_mm && bottom_mm <= other.bottom_mm &&
           other.top_mm <= top_mm;
}

Box Box::grown(double by_mm) const
{
    return {left_mm - by_mm, bottom_mm - by_mm, right_mm + by_mm, top_mm + by_mm};
}

Box sheetBox(Sheet sheet)
{
    switch (sheet) {
        case Sheet::A4Landscape: return {0, 0, 297, 210};
        case Sheet::A4Portrait: return {0, 0, 210, 297};
        case Sheet::A3Landscape: return {0, 0, 420, 297};
    }
    return {};
}

Box frameBox(Sheet sheet)
{
    const Box all = sheetBox(sheet);
    return {all.left_mm + 20, all.bottom_mm + 10, all.right_mm - 10, all.top_mm - 10};
}

const char* name(Sheet sheet)
{
    return sheet == Sheet::A3Landscape ? "A3" : "A4";
}

std::string Scale::text() const
{
    return fmt::format("{}:{}", paper, real);
}

const std::vector<Scale>& scales()
{
    static const std::vector<Scale> all = {{10, 1}, {5, 1},  {2, 1},   {1, 1},   {1, 2},   {1, 5},   {1, 10},
                                           {1, 20}, {1, 50}, {1, 100}, {1, 200}, {1, 500}, {1, 1000}};
    return all;
}

double textWidth_mm(std::string_view text, double height_mm)
{
    int sum = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character character = utf8At(text, at);
        sum += character.length == 0 ? otherCharacterWidth : advanceOf(character.code);
        at += std::max<std::size_t>(1, character.length);
    }
    return sum / 1000.0 * height_mm * fontSizeOverHeight;
}

Box boxOf(const Label& label)
{
    const double width = textWidth_mm(label.text, label.height_mm);
    const double start = label.anchor == Anchor::Start ? 0 : label.anchor == Anchor::Middle ? -width / 2 : -width;
    const double angle = label.angle_deg * std::numbers::pi / 180;
    const Vector2d along(std::cos(angle), std::sin(angle)), up(-along.y(), along.x());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{infinity, infinity, -infinity, -infinity};
    for (const double x : {start, start + width})
        for (const double y : {-descentShare * label.height_mm, ascentShare * label.height_mm})
            grow(box, label.at_mm + x * along + y * up);
    return box;
}

Box boxOf(const Drawing& drawing)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{infinity, infinity, -infinity, -infinity};
    for (const Line& line : drawing.lines)
        for (const Vector2d& point : {line.from_mm, line.to_mm}) grow(box, point);
    for (const Arc& arc : drawing.arcs)
        for (int i = 0; i <= 16; ++i) {
            const double angle = (arc.start_deg + (arc.end_deg - arc.start_deg) * i / 16) * std::numbers::pi / 180;
            grow(box, arc.centre_mm + arc.radius_mm * Vector2d(std::cos(angle), std::sin(angle)));
        }
    for (const Label& label : drawing.labels) {
        const Box covered = boxOf(label);
        grow(box, {covered.left_mm, covered.bottom_mm});
        grow(box, {covered.right_mm, covered.top_mm});
    }
    for (const Arrow& arrow : drawing.arrows)
        for (const double back : {0.0, arrow.length_mm}) grow(box, arrow.tip_mm - back * arrow.direction);
    return box.left_mm > box.right_mm ? Box{} : box;
}

bool passes(const Line& line, const Box& box)
{
    double first = 0, last = 1;  // Liang and Barsky, 1984
    const Vector2d run = line.to_mm - line.from_mm;
    const auto cut = [&](double p, double q) {
        if (p == 0) return q > 0;
        (p < 0 ? first : last) = p < 0 ? std::max(first, q / p) : std::min(last, q / p);
        return first < last;
    };
    return cut(-run.x(), line.from_mm.x() - box.left_mm) && cut(run.x(), box.right_mm - line.from_mm.x()) &&
           cut(-run.y(), line.from_mm.y() - box.bottom_mm) && cut(run.y(), box.top_mm - line.from_mm.y());
}

void move(Drawing& drawing, const Vector2d& by_mm)
{
    for (Line& line : drawing.lines) {
        line.from_mm += by_mm;
        line.to_mm += by_mm;
    }
    for (Arc& arc : drawing.arcs) arc.centre_mm += by_mm;
    for (Label& label : drawing.labels) label.at_mm += by_mm;
    for (Arrow& arrow : drawing.arrows) arrow.tip_mm += by_mm;
    drawing.origin_mm += by_mm;
}

void append(Drawing& drawing, const Drawing& other)
{
    drawing.lines.insert(drawing.lines.end(), other.lines.begin(), other.lines.end());
    drawing.arcs.insert(drawing.arcs.end(), other.arcs.begin(), other.arcs.end());
    drawing.labels.insert(drawing.labels.end(), other.labels.begin(), other.labels.end());
    drawing.arrows.insert(drawing.arrows.end(), other.arrows.begin(), other.arrows.end());
}

}  // namespace lathelier::drawing
