#include "engine/drawing/title_block.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "engine/core/texts.h"
#include "engine/core/utf8.h"
#include "engine/drawing/dimension_texts.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double blockWidth_mm = titleBlockWidth_mm;
constexpr double cellPadding_mm = 1.2;
constexpr double captionHeight_mm = 1.6;   // height of captions
constexpr double smallestHeight_mm = 1.4;  // height of contents that are long
constexpr double projectionWidth_mm = 25;  // of the cell of the symbol, right of the name
constexpr double nameWidth_mm = 80;

struct Cell {
    Text caption;
    std::string content;
    double width_mm = 0;
    double height_mm = 2.5;  ///< of its lettering
};

struct BlockRow {
    double height_mm = 9;
    std::vector<Cell> cells;
};

std::vector<BlockRow> rowsOf(const Shaft& shaft, const DrawingOptions& options, const std::string& scale,
                             const std::string& format)
{
    std::vector<BlockRow> rows;
    const RecoveredFrom& recovered = shaft.recovered;
    const auto remark = [&](Text english) {
        rows.push_back({5.5, {{{}, translated(english, options), blockWidth_mm, 2.2}}});
    };
    if (hasMeasured(shaft, options))
        remark(LT_TEXT("Engine", "italic: as measured; not a specification. ± U: k = 2; no ±: U is not known"));
    if (recovered.stated_length_mm)
        rows.push_back(
            {5.5,
             {{{},
               fill(translated(LT_TEXT("Engine", "The length of {length} mm was stated; an end is not seen."), options),
                    {{"length", shortNumber(*recovered.stated_length_mm, 3, options.decimal_separator)}}),
               blockWidth_mm,
               2.2}}});
    if (!recovered.scan.empty()) {
        rows.push_back({9,
                        {{LT_TEXT("Engine", "Scan"), recovered.scan, 62},
                         {LT_TEXT("Engine", "SHA-256"), recovered.scan_sha256, 118, 2}}});
    }
    const std::string material = !options.material.empty() ? options.material
                                 : shaft.material          ? shaft.material->name
                                                           : std::string();
    const std::optional<double> mass = massInKilograms(shaft);
    const Text mass_caption = shaft.marks.empty() ? LT_TEXT("Engine", "Mass") : LT_TEXT("Engine", "Mass without marks");
    rows.push_back({9,
                    {{LT_TEXT("Engine", "Material"), material, 75},
                     {mass_caption, mass ? roundedNumber(*mass, options.decimal_separator) + " kg" : std::string(), 30},
                     {LT_TEXT("Engine", "General tolerances"), shaft.general_tolerance, 75}}});
    rows.push_back({9,
                    {{LT_TEXT("Engine", "Method"), recovered.method, 30},
                     {LT_TEXT("Engine", "Surface texture"), options.surface_texture, 45},
                     {LT_TEXT("Engine", "Author"), options.author, 65},
                     {LT_TEXT("Engine", "Date"), options.date, 40}}});
    rows.push_back({12,
                    {{LT_TEXT("Engine", "Name"), options.name.empty() ? shaft.name : options.name, nameWidth_mm, 4},
                     {LT_TEXT("Engine", "Projection"), {}, projectionWidth_mm},
                     {LT_TEXT("Engine", "Scale"), scale, 25, 3.5},
                     {LT_TEXT("Engine", "Sheet"), options.sheet_number, 25, 3.5},
                     {LT_TEXT("Engine", "Format"), format, 25, 3.5}}});
    return rows;
}

/// Symbol of first-angle projection (ISO 5456-2): a cone, and right of it what is seen from its small end.
Drawing firstAngleSymbol(const Vector2d& centre)
{
    constexpr double small = 1.5, large = 3, length = 5, apart = 6;
    Drawing symbol;
    const double left = centre.x() - 4 - length / 2, right = left + length;
    const auto at = [&](double x, double y) { return Vector2d(x, centre.y() + y); };
    const std::array corners{at(left, -small), at(left, small), at(right, large), at(right, -large)};
    for (std::size_t i = 0; i < corners.size(); ++i)
        symbol.lines.push_back({corners[i], corners[(i + 1) % corners.size()], Layer::Frame, thin_mm});
    const Vector2d circles = at(right + apart, 0);
    for (const double radius : {small, large}) symbol.arcs.push_back({circles, radius, 0, 360, Layer::Frame, thin_mm});
    symbol.lines.push_back({at(left - 1, 0), at(right + 1, 0), Layer::Frame, thin_mm, LineType::DashDot});
    for (const Vector2d& axis : {Vector2d(large + 1, 0), Vector2d(0, large + 1)})
        symbol.lines.push_back({circles - axis, circles + axis, Layer::Frame, thin_mm, LineType::DashDot});
    return symbol;
}

}  // namespace

void fitInto(Label& label, double width_mm)
{
    const double wide = textWidth_mm(label.text, label.height_mm);
    if (wide <= width_mm) return;
    const double shrunk = label.height_mm * width_mm / wide;
    label.height_mm = std::max(smallestHeight_mm, shrunk);
    if (shrunk >= smallestHeight_mm) return;
    std::size_t count = countCharacters(label.text);
    std::string shortened;
    do {
        shortened = std::string(firstCharacters(label.text, --count)) + "…";
    } while (count > 0 && textWidth_mm(shortened, label.height_mm) > width_mm);
    label.text = shortened;
}

double titleBlockHeight_mm(const Shaft& shaft, const DrawingOptions& options)
{
    double height = 0;
    for (const BlockRow& row : rowsOf(shaft, options, {}, {})) height += row.height_mm;
    return height;
}

Drawing titleBlock(const Shaft& shaft, const DrawingOptions& options, Sheet sheet, const Scale& scale)
{
    Drawing drawing;
    const Box frame = frameBox(sheet);
    const auto line = [&](const Vector2d& from, const Vector2d& to, double width) {
        drawing.lines.push_back({from, to, Layer::Frame, width});
    };
    const auto rectangle = [&](const Box& box) {
        line({box.left_mm, box.bottom_mm}, {box.right_mm, box.bottom_mm}, thick_mm);
        line({box.right_mm, box.bottom_mm}, {box.right_mm, box.top_mm}, thick_mm);
        line({box.right_mm, box.top_mm}, {box.left_mm, box.top_mm}, thick_mm);
        line({box.left_mm, box.top_mm}, {box.left_mm, box.bottom_mm}, thick_mm);
    };
    rectangle(frame);
    const double left = frame.right_mm - blockWidth_mm;
    double top = frame.bottom_mm + titleBlockHeight_mm(shaft, options);
    rectangle({left, frame.bottom_mm, frame.right_mm, top});
    for (const BlockRow& row : rowsOf(shaft, options, scale.text(), name(sheet))) {
        const double bottom = top - row.height_mm;
        if (bottom > frame.bottom_mm + 1e-6) line({left, bottom}, {frame.right_mm, bottom}, thin_mm);
        double x = left;
        for (const Cell& cell : row.cells) {
            if (x > left) line({x, bottom}, {x, top}, thin_mm);
            const double room = cell.width_mm - 2 * cellPadding_mm;
            if (!cell.caption.empty()) {
                Label caption{{x + cellPadding_mm, top - cellPadding_mm - captionHeight_mm}, captionHeight_mm};
                caption.text = translated(cell.caption, options);
                fitInto(caption, room);
                drawing.labels.push_back(caption);
            }
            if (!cell.content.empty()) {
                Label content{{x + cellPadding_mm, bottom + 0.6 + 0.4 * cell.height_mm}, cell.height_mm};
                content.text = cell.content;
                content.italic = cell.caption.empty();
                fitInto(content, room);
                drawing.labels.push_back(content);
            }
            x += cell.width_mm;
        }
        top = bottom;
    }
    append(drawing, firstAngleSymbol({left + nameWidth_mm + projectionWidth_mm / 2, frame.bottom_mm + 4.6}));
    return drawing;
}

}  // namespace lathelier::drawing
