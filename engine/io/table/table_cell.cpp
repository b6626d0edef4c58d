#include "engine/io/table/table_cell.h"

#include <algorithm>

#include "engine/io/io_codes.h"
#include "engine/io/text/number.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr std::size_t longestNumber = 1000;  ///< characters; the exact value of a double has 767 digits at most

bool isGroupMark(char c, char decimal)
{
    return c != decimal && (c == ',' || c == '.' || c == '\'' || c == ' ');
}

/// A number whose integer part may be grouped by threes.
struct Ungrouped {
    bool valid = false;
    int groups = 0;  ///< number of groups after the first
    char mark = 0;   ///< separator of the groups
    double value = 0;
};

Ungrouped ungroup(std::string_view cell, char decimal)
{
    Ungrouped result;
    if (cell.size() > longestNumber) return result;
    std::string plain;
    std::size_t i = 0;
    if (i < cell.size() && (cell[i] == '-' || cell[i] == '+')) plain += cell[i++];
    std::size_t run = 0;
    const std::size_t first = i;
    for (; i < cell.size(); ++i) {
        const char c = cell[i];
        if (detail::isDigit(c)) {
            plain += c;
            ++run;
        } else if (isGroupMark(c, decimal) && (result.mark == 0 || result.mark == c)) {
            if (result.groups == 0 ? run < 1 || run > 3 || cell[first] == '0' : run != 3) return result;
            result.mark = c;
            ++result.groups;
            run = 0;
        } else {
            break;
        }
    }
    if (result.groups > 0 && (run != 3 || (i < cell.size() && cell[i] != decimal))) return result;
    plain += cell.substr(i);
    if (const auto value = wholeNumber(plain, decimal)) {
        result.valid = true;
        result.value = *value;
    }
    return result;
}

/// A number followed by a unit: "26.7mm", "1.05 in", "1.05\"".
bool splitSuffix(Cell cell, Cell& number, Cell& suffix)
{
    if (cell.empty() ||
        !(detail::isDigit(cell.front()) || cell.front() == '-' || cell.front() == '+' || cell.front() == '.'))
        return false;
    const std::size_t last = cell.find_last_of("0123456789.");
    if (last == Cell::npos || last + 1 >= cell.size() || !lengthUnit(cell.substr(last + 1))) return false;
    number = cell.substr(0, last + 1);
    suffix = trimmed(cell.substr(last + 1));
    return true;
}

/// The part of the line before a remark at its end.
std::string_view withoutRemark(std::string_view line, char delimiter)
{
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        const bool slashes = c == '/' && i + 1 < line.size() && line[i + 1] == '/';
        const bool semicolon =
            c == ';' && delimiter != ';' && (i + 1 == line.size() || (i > 0 && isBlank(line[i - 1])));
        // 1.#QNAN and #N/A are invalid numbers, not remarks.
        const bool hash =
            c == '#' && !(i > 0 && (line[i - 1] == '.' || line[i - 1] == ',')) && line.substr(i, 4) != "#N/A";
        if (slashes || semicolon || hash || c == '%' || c == '!') return line.substr(0, i);
    }
    return line;
}

std::string_view withoutBrackets(std::string_view line)
{
    line = trimmed(line);
    const std::string_view whole = line;
    while (!line.empty() && std::string_view("([{").find(line.front()) != std::string_view::npos)
        line = trimmed(line.substr(1));
    if (line.size() == whole.size()) return whole;
    while (!line.empty() && std::string_view(")]},;").find(line.back()) != std::string_view::npos)
        line = trimmed(line.substr(0, line.size() - 1));
    return line;
}

bool isMark(char c)
{
    return c == '.' || c == ',';
}

/// True when a real number (digits with a decimal mark) starts at `at`.
bool isRealAt(Cell word, std::size_t at)
{
    while (at < word.size() && detail::isDigit(word[at])) ++at;
    return at < word.size() && isMark(word[at]);
}

/// Splits "6.90735-16.07329" before each sign that starts a real number after a real number.
void addTouchingReals(Cell word, std::vector<Cell>& cells)
{
    std::size_t begin = 0;
    bool real = false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        real = real || isMark(word[i]);
        const bool sign = i > begin && (word[i] == '-' || word[i] == '+');
        if (!sign || !real || !(detail::isDigit(word[i - 1]) || word[i - 1] == '.') || !isRealAt(word, i + 1)) continue;
        cells.push_back(word.substr(begin, i - begin));
        begin = i;
        real = false;
    }
    cells.push_back(word.substr(begin));
}

void splitAtBlanks(std::string_view line, std::vector<Cell>& cells)
{
    std::size_t p = 0;
    while (p < line.size()) {
        if (isBlank(line[p])) {
            ++p;
        } else if (line[p] == '"' || line[p] == '\'') {
            const std::size_t close = std::min(line.find(line[p], p + 1), line.size());
            cells.push_back(trimmed(line.substr(p + 1, close - p - 1)));
            p = std::min(close + 1, line.size());
        } else {
            const std::size_t begin = p;
            while (p < line.size() && !isBlank(line[p])) ++p;
            const Cell word = line.substr(begin, p - begin);
            const bool number =
                detail::isDigit(word.front()) || word.front() == '-' || word.front() == '+' || word.front() == '.';
            if (number)
                addTouchingReals(word, cells);
            else
                cells.push_back(word);
        }
    }
}

void splitAtDelimiter(std::string_view line, char delimiter, std::vector<Cell>& cells)
{
    std::size_t p = 0;
    for (;;) {
        while (p < line.size() && isBlank(line[p]) && line[p] != delimiter) ++p;
        Cell cell;
        if (line.substr(p, 2) == "=\"") ++p;  // ="1.5" keeps Excel from touching the number
        if (p < line.size() && (line[p] == '"' || line[p] == '\'')) {
            const std::size_t close = std::min(line.find(line[p], p + 1), line.size());
            cell = line.substr(p + 1, close - p - 1);
            p = line.find(delimiter, close);
        } else {
            const std::size_t end = line.find(delimiter, p);
            cell = line.substr(p, end == std::string_view::npos ? end : end - p);
            p = end;
        }
        cells.push_back(trimmed(cell));
        if (p == std::string_view::npos) return;
        ++p;
    }
}

/// Joins cells in pairs: the comma between them is a decimal mark.
void joinPairs(std::vector<Cell>& cells)
{
    if (cells.size() % 2 != 0) return;
    for (std::size_t i = 0; i < cells.size() / 2; ++i) {
        const char* begin = cells[2 * i].data();
        const char* end = cells[2 * i + 1].data() + cells[2 * i + 1].size();
        cells[i] = Cell(begin, static_cast<std::size_t>(end - begin));
    }
    cells.resize(cells.size() / 2);
}

}  // namespace

CellEvidence evidenceOf(Cell cell)
{
    const Ungrouped point = ungroup(cell, '.');
    const Ungrouped comma = ungroup(cell, ',');
    if (point.valid && comma.valid) {
        if (point.mark == ',') return {Evidence::LoneComma, 0};
        if (comma.mark == '.') return {Evidence::LonePoint, 0};
        return {Evidence::NoMark, 0};
    }
    if (point.valid) return {Evidence::Point, point.mark};
    if (comma.valid) return {Evidence::Comma, comma.mark};
    Cell number;
    Cell suffix;
    return splitSuffix(cell, number, suffix) ? evidenceOf(number) : CellEvidence{};
}

bool looksLikeNumber(Cell cell)
{
    return evidenceOf(cell).evidence != Evidence::NoNumber || isNotFiniteWord(cell);
}

void splitFields(std::string_view line, char delimiter, std::vector<Cell>& cells)
{
    cells.clear();
    if (delimiter == ' ') return splitAtBlanks(line, cells);
    if (delimiter == '|' && line.starts_with('|')) line.remove_prefix(1);  // | 1 | 2 | 3 |
    splitAtDelimiter(line, delimiter, cells);
}

void splitCells(std::string_view line, const TableStyle& style, std::vector<Cell>& cells)
{
    splitFields(withoutBrackets(withoutRemark(line, style.delimiter)), style.delimiter, cells);
    if (style.paired) joinPairs(cells);
}

void dropEmptyEnd(std::vector<Cell>& cells, std::size_t columns)
{
    while (cells.size() > columns && cells.back().empty()) cells.pop_back();
}

CellValue readCell(Cell cell, const TableStyle& style)
{
    if (cell.empty()) return {CellKind::Empty, 0, {}};
    if (cell.size() > longestNumber) return {CellKind::Text, 0, {}};
    if (const auto value = wholeNumber(cell, style.decimal)) return {CellKind::Number, *value, {}};
    if (isNotFiniteWord(cell)) return {CellKind::NotFinite, 0, {}};
    const Ungrouped grouped = ungroup(cell, style.decimal);
    if (grouped.valid) {
        const bool lone = grouped.groups == 1 && (grouped.mark == ',' || grouped.mark == '.') &&
                          cell.find(style.decimal) == Cell::npos;
        return {lone && !style.grouped ? CellKind::Ambiguous : CellKind::Number, grouped.value, {}};
    }
    Cell number;
    Cell suffix;
    if (splitSuffix(cell, number, suffix)) {
        CellValue value = readCell(number, style);
        value.suffix = suffix;
        return value;
    }
    return {CellKind::Text, 0, {}};
}

Error ambiguousNumber(std::int64_t number, std::string_view line, Cell cell)
{
    const Error place = malformed(number, line, cell, {});
    Cell suffix;
    splitSuffix(cell, cell, suffix);
    const bool comma = cell.find(',') != Cell::npos;
    const Ungrouped first = ungroup(cell, comma ? ',' : '.');
    const Ungrouped second = ungroup(cell, comma ? '.' : ',');
    // "12,45" is not a grouped number, but may be two cells.
    const std::size_t mark = cell.find(',');
    const Value two = second.valid
                          ? Value(second.value)
                          : Value(std::string(cell.substr(0, mark)) + " | " + std::string(cell.substr(mark + 1)));
    return Error(errors::numberAmbiguous, {{"line", number},
                                           {"column", *find(place.values(), "column")},
                                           {"found", std::string(cell)},
                                           {"first", first.value},
                                           {"second", two}});
}

bool isRemark(std::string_view line, char delimiter)
{
    line = trimmed(line);
    if (line.empty()) return false;
    if (line.starts_with("#N/A")) return false;
    return line.front() == '#' || line.starts_with("//") || line.front() == '%' || line.front() == '!' ||
           line.front() == '*' || (line.front() == ';' && delimiter != ';');
}

}  // namespace lathelier::io
