// Determines the layout of a table: separator, decimal mark, columns, first row.
#include "engine/io/table/table_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/io/io_codes.h"
#include "engine/io/table/table_headings.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::size_t sampleLines = 500;
constexpr std::size_t mostHeadings = 100;                    ///< largest number of headings recognised when repeated
constexpr std::size_t longestSearch = std::size_t{1} << 20;  ///< bytes within which the rows of numbers must begin

bool isBlankLine(std::string_view line)
{
    return line.find_first_not_of(" \t\v\f,;|\"") == std::string_view::npos;
}

/// "sep=;" is Excel's declaration of the separator.
std::optional<Delimiter> excelSeparator(std::string_view line)
{
    line = trimmed(line);
    if (line.size() > 1 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
    if (line.size() != 5 || lowerCase(line.substr(0, 4)) != "sep=") return std::nullopt;
    switch (line[4]) {
        case ',': return Delimiter::Comma;
        case ';': return Delimiter::Semicolon;
        case '\t': return Delimiter::Tab;
        case '|': return Delimiter::Pipe;
        case ' ': return Delimiter::Space;
        default: return std::nullopt;
    }
}

/// The first lines that are neither blank nor remarks, enough to include some rows.
std::vector<SampleLine> takeSample(std::string_view text, std::size_t count)
{
    std::vector<SampleLine> sample;
    Lines lines(text.substr(0, longestSearch));
    while (sample.size() < count && lines.next()) {
        const bool cut = lines.nextOffset() == longestSearch && text.size() > longestSearch;
        if (cut && !sample.empty()) break;
        if (!isBlankLine(lines.line()) && !isRemark(lines.line(), ';'))
            sample.push_back({lines.line(), lines.number(), lines.offset()});
    }
    return sample;
}

std::size_t countNumbers(const std::vector<Cell>& cells, const TableStyle& style)
{
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [&style](Cell cell) {
        const CellKind kind = readCell(cell, style).kind;
        return kind == CellKind::Number || kind == CellKind::NotFinite || kind == CellKind::Ambiguous;
    }));
}

/// The first two values of a row as whole numbers.
using GridPlace = std::pair<std::int64_t, std::int64_t>;

std::optional<std::int64_t> smallInteger(Cell cell)
{
    constexpr std::int64_t largest = 10'000'000;
    const auto value = wholeInteger(cell);
    return value && *value >= -largest && *value <= largest ? value : std::nullopt;
}

/// True for places that differ and run along a grid: one index never turns back, the other counts within each of its
/// rows, in either direction.
bool walkGrid(const std::vector<GridPlace>& places)
{
    constexpr std::size_t fewest = 8;
    if (places.size() < fewest) return false;
    const auto isOrdered = [&places](auto outer, auto inner) {
        std::int64_t outerWay = 0, innerWay = 0, span = 0;
        std::size_t counted = 0;
        const auto way = [](std::int64_t change) { return change > 0 ? 1 : -1; };
        for (std::size_t i = 1; i < places.size(); ++i) {
            const std::int64_t step = outer(places[i]) - outer(places[i - 1]);
            const std::int64_t along = inner(places[i]) - inner(places[i - 1]);
            if (step != 0) {
                if (outerWay != 0 && way(step) != outerWay) return false;
                outerWay = way(step);
                innerWay = 0;
                continue;
            }
            if (along == 0 || (innerWay != 0 && way(along) != innerWay)) return false;
            innerWay = way(along);
            span += std::abs(along);
            ++counted;
        }
        // Points may be missing, but most places of a row are there.
        return 2 * counted >= places.size() && span < 4 * static_cast<std::int64_t>(counted);
    };
    const auto first = [](const GridPlace& place) { return place.first; };
    const auto second = [](const GridPlace& place) { return place.second; };
    return isOrdered(first, second) || isOrdered(second, first);
}

/// True when the columns 4 to 6 of a row are a direction of unit length: the normal at x, y, z.
bool holdsNormal(const std::vector<Cell>& cells, const TableStyle& style)
{
    if (cells.size() < 6) return false;
    double square = 0;
    for (std::size_t k = 3; k < 6; ++k) {
        const CellValue value = readCell(cells[k], style);
        if (value.kind != CellKind::Number) return false;
        square += value.value * value.value;
    }
    return std::abs(square - 1) < 0.01;
}

/// Content of each column, from the sample's rows.
std::vector<TableColumn> studyColumns(const std::vector<SampleLine>& sample, const StyleFound& found)
{
    std::vector<TableColumn> columns(found.columns);
    std::vector<std::size_t> numbers(found.columns, 0);
    std::vector<double> last(found.columns, std::nan(""));
    std::vector<bool> goesUp(found.columns, true);
    std::size_t rows = 0;
    std::vector<Cell> cells;
    std::vector<GridPlace> places;
    for (const SampleLine& line : sample) {
        splitCells(line.text, found.style, cells);
        dropEmptyEnd(cells, found.columns);
        if (cells.size() != found.columns || countNumbers(cells, found.style) * 2 < cells.size()) continue;
        ++rows;
        if (cells.size() > 2 && !holdsNormal(cells, found.style))
            if (const auto a = smallInteger(cells[0]), b = smallInteger(cells[1]); a && b) places.emplace_back(*a, *b);
        for (std::size_t k = 0; k < found.columns; ++k) {
            const CellValue value = readCell(cells[k], found.style);
            if (value.kind != CellKind::Text && value.kind != CellKind::Empty) ++numbers[k];
            if (value.kind != CellKind::Number) continue;
            if (!value.suffix.empty()) columns[k].unit = lengthUnit(value.suffix);
            columns[k].has_decimal_marks = columns[k].has_decimal_marks || cells[k].find_first_of(".,") != Cell::npos;
            if (!std::isnan(last[k]) && value.value != last[k] + 1) goesUp[k] = false;
            last[k] = value.value;
        }
    }
    for (std::size_t k = 0; k < found.columns; ++k) {
        columns[k].is_number = rows > 0 && numbers[k] * 2 >= rows;
        columns[k].is_count = columns[k].is_number && goesUp[k] && !columns[k].has_decimal_marks && rows >= 3;
    }
    if (places.size() == rows && walkGrid(places)) columns[0].is_grid_index = columns[1].is_grid_index = true;
    return columns;
}

bool isDataRow(const std::vector<Cell>& cells, const TableLayout& layout)
{
    if (cells.size() != layout.columns.size()) return false;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const CellKind kind = readCell(cells[k], layout.style).kind;
        if (layout.columns[k].is_number && (kind == CellKind::Text || kind == CellKind::Empty)) return false;
    }
    return true;
}

/// Whether a text can follow a decimal comma.
bool isFraction(Cell cell, bool withExponent)
{
    const std::size_t digits = cell.find_first_not_of("0123456789");
    return digits == Cell::npos || (withExponent && digits > 0 && (cell[digits] | 0x20) == 'e');
}

/// Commas between whole numbers only: "26,74906,6,90735,-16,07329" may be three numbers or six, and if one column is
/// sufficient, "0,250" may be one or two.
void resolveCommaPairs(const std::vector<SampleLine>& sample, const ImportOptions& options,
                       const TableExpectation& expected, std::size_t namedColumns, StyleFound& found)
{
    const bool oneWillDo = expected.minimum_columns == 1 && options.delimiter == Delimiter::Auto;
    const std::size_t fewest = oneWillDo ? 2 : 4;
    if (found.style.delimiter != ',' || found.columns < fewest || found.columns % 2 != 0 ||
        namedColumns == found.columns)
        return;
    std::vector<Cell> cells;
    const SampleLine* first = nullptr;
    Cell firstCell;
    bool sameLength = true;
    bool leadingZero = false;
    bool negativeZero = false;  // "-0" is never an integer
    std::size_t length = 0;
    for (const SampleLine& line : sample) {
        splitCells(line.text, found.style, cells);
        dropEmptyEnd(cells, found.columns);
        if (cells.size() != found.columns || countNumbers(cells, found.style) != found.columns) continue;
        for (std::size_t k = 0; k < cells.size(); k += 2) {
            const Cell fraction = cells[k + 1];
            if (!wholeInteger(cells[k]) || !isFraction(fraction, oneWillDo)) return;
            if (!first) {
                first = &line;
                firstCell = Cell(cells[k].data(),
                                 static_cast<std::size_t>(fraction.data() + fraction.size() - cells[k].data()));
                length = fraction.size();
            }
            sameLength = sameLength && fraction.size() == length;
            leadingZero = leadingZero || (fraction.size() > 1 && fraction.front() == '0');
            negativeZero = negativeZero || cells[k] == "-0";
        }
    }
    if (!first || options.decimal == Decimal::Point) return;
    const bool certain = options.decimal == Decimal::Comma || namedColumns * 2 == found.columns ||
                         (sameLength && leadingZero) || (oneWillDo && negativeZero);
    if (!certain) throw ambiguousNumber(first->number, first->text, firstCell);
    found.style.decimal = ',';
    found.style.paired = found.columns > 2;
    found.columns /= 2;
    if (found.columns == 1) found.style.delimiter = '\t';
}

std::string_view withoutMark(std::string_view line)
{
    line = trimmed(line);
    while (!line.empty() && std::string_view("#/%!;*").find(line.front()) != std::string_view::npos)
        line.remove_prefix(1);
    return trimmed(line);
}

/// Error for a text without a row of numbers.
[[noreturn]] void throwNoRows(const std::vector<SampleLine>& sample, const TableExpectation& expectation,
                              const ImportOptions& options)
{
    if (expectation.minimum_columns > 1) {
        const StyleFound narrow = findStyle(sample, {}, 1, options);
        std::vector<Cell> cells;
        std::vector<Cell> firstCells;
        std::size_t rows = 0;
        const SampleLine* first = nullptr;
        for (const SampleLine& line : sample) {
            splitCells(line.text, narrow.style, cells);
            dropEmptyEnd(cells, narrow.columns);
            if (narrow.columns == 0 || cells.size() != narrow.columns ||
                countNumbers(cells, narrow.style) != cells.size())
                continue;
            if (!first) {
                first = &line;
                firstCells = cells;
            }
            ++rows;
        }
        if (first && rows * 2 >= sample.size())
            throw columnsDiffer(first->number, first->text, firstCells, expectation.minimum_columns);
    }
    throw Error(errors::formatUnknown, {{"line", sample.empty() ? std::int64_t{1} : sample.front().number},
                                        {"column", std::int64_t{1}},
                                        {"found", LT_TEXT("Engine", "text without rows of numbers")},
                                        {"expected", LT_TEXT("Engine", "rows of numbers")}});
}

/// Fewer columns of numbers than required: the given decimal mark is inconsistent.
void requireNumbers(const std::vector<SampleLine>& sample, const TableExpectation& expectation,
                    const TableLayout& layout)
{
    const auto numbers = std::count_if(layout.columns.begin(), layout.columns.end(),
                                       [](const TableColumn& column) { return column.is_number; });
    if (static_cast<std::size_t>(numbers) >= expectation.minimum_columns) return;
    std::vector<Cell> cells;
    for (const SampleLine& line : sample) {
        splitCells(line.text, layout.style, cells);
        dropEmptyEnd(cells, layout.columns.size());
        if (cells.size() != layout.columns.size()) continue;
        for (const Cell cell : cells)
            if (countNumbers({cell}, layout.style) == 0 && cell.find_first_of("0123456789") != Cell::npos)
                throw malformed(line.number, line.text, cell,
                                layout.style.decimal == ',' ? LT_TEXT("Engine", "a number with a decimal comma")
                                                            : LT_TEXT("Engine", "a number with a decimal point"));
    }
    throwNoRows(sample, expectation, {});
}

/// The lines above the table.
struct Above {
    std::vector<PrefaceLine> preface;
    std::vector<SampleLine> numeric;  ///< lines that consist of numbers
};

/// Classifies a numeric line above the first row: a row count, or a malformed row.
void studyNumericLine(const SampleLine& line, TableLayout& layout)
{
    std::vector<Cell> cells;
    splitCells(line.text, layout.style, cells);
    dropEmptyEnd(cells, layout.columns.size());
    if (cells.size() == layout.columns.size()) {
        for (std::size_t k = 0; k < cells.size(); ++k)
            if (layout.columns[k].is_number && countNumbers({cells[k]}, layout.style) == 0)
                throw malformed(line.number, line.text, cells[k], LT_TEXT("Engine", "a number"));
    }
    const bool integers =
        std::all_of(cells.begin(), cells.end(), [](Cell cell) { return wholeInteger(cell).has_value(); });
    if (!integers || cells.size() > 2 || cells.size() >= layout.columns.size())
        throw columnsDiffer(line.number, line.text, cells, layout.columns.size());
    if (cells.size() == 1) layout.announced_rows = wholeInteger(cells[0]);
}

/// Advances to the first row and records the lines above it. False when there is no row.
bool findBody(std::string_view text, TableLayout& layout, Above& above)
{
    above = {};
    layout.skipped.clear();
    layout.headings.clear();
    std::vector<Cell> cells;
    Lines lines(text);
    while (lines.next() && lines.offset() < longestSearch) {
        const std::string_view line = lines.line();
        if (isBlankLine(line)) {
            layout.skipped.push_back({lines.number(), LT_TEXT("Engine", "blank line")});
            continue;
        }
        if (isRemark(line, layout.style.delimiter)) {
            above.preface.push_back({withoutMark(line), true, layout.skipped.size()});
            layout.skipped.push_back({lines.number(), LT_TEXT("Engine", "remark")});
            continue;
        }
        splitCells(line, layout.style, cells);
        dropEmptyEnd(cells, layout.columns.size());
        if (isDataRow(cells, layout)) {
            layout.body_offset = lines.offset();
            layout.body_line = lines.number();
            return true;
        }
        const std::size_t numbers = countNumbers(cells, layout.style);
        const bool broken = cells.size() == layout.columns.size() && numbers * 2 >= cells.size() && numbers > 0 &&
                            countNumbers({cells.front()}, layout.style) == 1;
        if (numbers == cells.size() || broken) {
            above.numeric.push_back({line, lines.number(), lines.offset()});
            layout.skipped.push_back({lines.number(), LT_TEXT("Engine", "number of rows")});
        } else {
            above.preface.push_back({trimmed(line), false, layout.skipped.size()});
            if (layout.headings.size() < mostHeadings) layout.headings.emplace_back(line);
            layout.skipped.push_back({lines.number(), LT_TEXT("Engine", "heading")});
        }
    }
    return false;
}

}  // namespace

Error columnsDiffer(std::int64_t number, std::string_view line, const std::vector<Cell>& cells, std::size_t expected)
{
    const std::string_view row = trimmed(line);
    const std::string_view end = row.substr(row.size());
    const Error place = malformed(number, line, cells.size() > expected ? cells[expected] : end, {});
    return Error(errors::malformed,
                 {{"line", number},
                  {"column", *find(place.values(), "column")},
                  {"found", excerpt(row)},
                  {"expected", cells.size() > expected ? LT_TEXT("Engine", "fewer columns")
                                                       : LT_TEXT("Engine", "more columns of numbers")},
                  {"found_columns", static_cast<std::int64_t>(cells.size())},
                  {"expected_columns", static_cast<std::int64_t>(expected)}});
}

TableLayout findLayout(std::string_view text, const TableExpectation& expectation, const ImportOptions& options)
{
    ImportOptions settled = options;
    std::vector<SampleLine> sample = takeSample(text, sampleLines);
    const auto separator = sample.empty() ? std::nullopt : excelSeparator(sample.front().text);
    if (separator && settled.delimiter == Delimiter::Auto) settled.delimiter = *separator;
    if (separator) sample.erase(sample.begin());
    StyleFound found = findStyle(sample, text, expectation.minimum_columns, settled);
    if (found.columns == 0) {  // the rows may follow a long preface
        sample = takeSample(text, std::numeric_limits<std::size_t>::max());
        found = findStyle(sample, text, expectation.minimum_columns, settled);
    }
    if (found.columns == 0) throwNoRows(sample, expectation, settled);

    TableLayout layout;
    layout.style = found.style;
    layout.columns = studyColumns(sample, found);
    requireNumbers(sample, expectation, layout);
    Above above;
    if (!findBody(text, layout, above)) throwNoRows(sample, expectation, settled);
    resolveCommaPairs(sample, settled, expectation,
                      countHeadings(above.preface, layout.style.delimiter, expectation, found.columns), found);
    if (found.columns != layout.columns.size()) {
        layout.style = found.style;
        layout.columns = studyColumns(sample, found);
        if (!findBody(text, layout, above)) throwNoRows(sample, expectation, settled);
    }
    for (const SampleLine& line : above.numeric) studyNumericLine(line, layout);
    for (const PrefaceLine& line : above.preface)
        if (!layout.unit) layout.unit = statedUnit(line.text);
    applyHeadings(above.preface, expectation, layout);
    return layout;
}

std::string delimiterName(const TableStyle& style)
{
    switch (style.delimiter) {
        case ',': return "comma";
        case ';': return "semicolon";
        case '\t': return "tab";
        case '|': return "pipe";
        default: return "space";
    }
}

std::string decimalName(const TableStyle& style)
{
    return style.decimal == ',' ? "comma" : "point";
}

}  // namespace lathelier::io
