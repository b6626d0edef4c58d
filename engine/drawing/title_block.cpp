#include "engine/drawing/title_block.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/core/utf8.h"
#include "engine/drawing/dimension_texts.h"

namespace lathelier::drawing {
namespace {

using Eigen::Vector2d;

constexpr double blockWidth_mm = 180;
constexpr double cellPadding_mm = 1.2;
constexpr double captionHeight_mm = 1.6;   // height of captions
constexpr double smallestHeight_mm = 1.4;  // height of contents that are long

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

std::string fileName(const std::string& path)
{
    const std::size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::vector<BlockRow> rowsOf(const Shaft& shaft, const DrawingOptions& options, const std::string& scale,
                             const std::string& format)
{
    std::vector<BlockRow> rows;
    if (options.legend || options.measured)
        rows.push_back(
            {5.5,
             {{{}, translated(LT_TEXT("Engine", "italic: as measured, ± U (k = 2)"), options), blockWidth_mm, 2.2}}});
    if (options.scan) {
        rows.push_back(
            {5.5,
             {{{},
               translated(LT_TEXT("Engine", "recovered from a scan; measured values are not a specification"), options),
               blockWidth_mm,
               2.2}}});
        rows.push_back({9,
                        {{LT_TEXT("Engine", "Scan"), fileName(options.scan->path), 62},
                         {LT_TEXT("Engine", "SHA-256"), options.scan->sha256, 118, 2}}});
    }
    const std::string material = !options.material.empty() ? options.material
                                 : shaft.material          ? shaft.material->name
                                                           : std::string();
    const std::optional<double> mass = massInKilograms(shaft);
    rows.push_back({9,
                    {{LT_TEXT("Engine", "Material"), material, 75},
                     {LT_TEXT("Engine", "Mass"),
                      mass ? roundedNumber(*mass, options.decimal_separator) + " kg" : std::string(), 30},
                     {LT_TEXT("Engine", "General tolerances"), shaft.general_tolerance, 75}}});
    rows.push_back(
        {9, {{LT_TEXT("Engine", "Method"), options.method, 105}, {LT_TEXT("Engine", "Date"), options.date, 75}}});
    rows.push_back({12,
                    {{LT_TEXT("Engine", "Name"), options.name.empty() ? shaft.name : options.name, 105, 4},
                     {LT_TEXT("Engine", "Scale"), scale, 25, 3.5},
                     {LT_TEXT("Engine", "Sheet"), options.sheet_number, 25, 3.5},
                     {LT_TEXT("Engine", "Format"), format, 25, 3.5}}});
    return rows;
}

/// Fits the label into a width: smaller, then shortened.
void fit(Label& label, double width_mm)
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

}  // namespace

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
                fit(caption, room);
                drawing.labels.push_back(caption);
            }
            if (!cell.content.empty()) {
                Label content{{x + cellPadding_mm, bottom + 0.6 + 0.4 * cell.height_mm}, cell.height_mm};
                content.text = cell.content;
                content.italic = cell.caption.empty();
                fit(content, room);
                drawing.labels.push_back(content);
            }
            x += cell.width_mm;
        }
        top = bottom;
    }
    return drawing;
}

}  // namespace lathelier::drawing
