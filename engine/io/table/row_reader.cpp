#include "engine/io/table/row_reader.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/io/text/number.h"

namespace lathelier::io {
namespace {

Error tooLarge(const Lines& lines, Cell cell, const WantedColumn& wanted)
{
    const Error place = malformed(lines.number(), lines.line(), cell, {});
    return Error(errors::coordinateTooLarge, {{"line", lines.number()},
                                              {"column", *find(place.values(), "column")},
                                              {"found", std::string(cell)},
                                              {"maximum", wanted.largest}});
}

}  // namespace

RowReader::RowReader(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted)
    : text_(text), layout_(layout), wanted_(wanted), slotOf_(layout.columns.size(), -1)
{
    for (std::size_t i = 0; i < wanted.size(); ++i) slotOf_[wanted[i].column] = static_cast<int>(i);
    // With a comma as both separator and decimal mark only the general parser can distinguish them.
    isPlain_ = layout.style.delimiter != layout.style.decimal &&
               std::all_of(layout.columns.begin(), layout.columns.end(),
                           [](const TableColumn& column) { return column.is_number; });
}

void RowReader::read(TableChunk& chunk, std::size_t chunkEnd, double* out) const
{
    Lines lines(text_, chunk.begin, chunk.first_line);
    std::size_t at = chunk.begin;
    std::int64_t number = chunk.first_line;
    std::vector<Cell> cells;
    while (at < chunkEnd) {
        if (isPlain_) {
            if (const std::size_t next = readPlain(at, out); next != 0) {
                accept(chunk, out);
                at = next;
                ++number;
                continue;
            }
        }
        lines = Lines(text_, at, number);
        lines.next();
        readThoroughly(lines, chunk, cells, out);
        at = lines.nextOffset();
        ++number;
    }
}

void RowReader::accept(TableChunk& chunk, double*& out) const
{
    out += wanted_.size();
    ++chunk.rows;
    if (chunk.first_text) chunk.rows_after_text = true;
}

std::size_t RowReader::readPlain(std::size_t at, double* out) const
{
    const char* p = text_.data() + at;
    const char* const end = text_.data() + text_.size();
    const char delimiter = layout_.style.delimiter;
    const char decimal = layout_.style.decimal;
    const std::size_t columns = slotOf_.size();
    const auto skipBlanks = [&] {
        while (p != end && (*p == ' ' || (*p == '\t' && delimiter != '\t'))) ++p;
    };
    for (std::size_t k = 0; k < columns; ++k) {
        skipBlanks();
        double value = 0;
        const char* const behind = parseNumber(p, end, decimal, value);
        if (!behind) return 0;
        const char* const numberEnd = behind;
        p = behind;
        if (const int slot = slotOf_[k]; slot >= 0) {
            if (!(std::abs(value) <= wanted_[static_cast<std::size_t>(slot)].largest) || std::isinf(value)) return 0;
            out[slot] = value;
        }
        skipBlanks();
        if (k + 1 == columns) break;
        if (delimiter == ' ') {
            if (p == numberEnd) return 0;
        } else {
            if (p == end || *p != delimiter) return 0;
            ++p;
        }
    }
    if (p != end && *p == delimiter && delimiter != ' ') {  // a separator ends the row
        ++p;
        skipBlanks();
    }
    if (p == end) return text_.size();
    if (*p == '\n') return static_cast<std::size_t>(p - text_.data()) + 1;
    if (*p == '\r') return static_cast<std::size_t>(p - text_.data()) + (p + 1 != end && p[1] == '\n' ? 2 : 1);
    return 0;
}

void RowReader::skip(TableChunk& chunk, std::int64_t number, Text reason) const
{
    ++chunk.skipped_count;
    if (chunk.skipped.size() < listedRows) chunk.skipped.push_back({number, reason});
}

void RowReader::readThoroughly(const Lines& lines, TableChunk& chunk, std::vector<Cell>& cells, double*& out) const
{
    const std::string_view line = lines.line();
    if (line.find_first_not_of(" \t\v\f,;|\"") == std::string_view::npos)
        return skip(chunk, lines.number(), LT_TEXT("Engine", "blank line"));
    if (isRemark(line, layout_.style.delimiter)) return skip(chunk, lines.number(), LT_TEXT("Engine", "remark"));
    splitCells(line, layout_.style, cells);
    dropEmptyEnd(cells, slotOf_.size());
    if (cells.size() == slotOf_.size() && readCells(lines, chunk, cells, out)) return;
    judgeText(lines, chunk, cells);
}

bool RowReader::readCells(const Lines& lines, TableChunk& chunk, const std::vector<Cell>& cells, double*& out) const
{
    bool finite = true;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        if (!layout_.columns[k].is_number) continue;
        const CellValue value = readCell(cells[k], layout_.style);
        const int slot = slotOf_[k];
        const WantedColumn* const wanted = slot >= 0 ? &wanted_[static_cast<std::size_t>(slot)] : nullptr;
        if (value.kind == CellKind::Ambiguous) throw ambiguousNumber(lines.number(), lines.line(), cells[k]);
        const bool missing = value.kind == CellKind::Empty && (!wanted || wanted->may_be_missing);
        if (value.kind == CellKind::Text || (value.kind == CellKind::Empty && !missing)) {
            if (isText(cells)) return false;
            throw malformed(lines.number(), lines.line(), cells[k], LT_TEXT("Engine", "a number"));
        }
        if (!wanted) continue;
        const bool number = value.kind == CellKind::Number && std::isfinite(value.value);
        if (value.kind == CellKind::Number && std::abs(value.value) > wanted->largest)
            throw tooLarge(lines, cells[k], *wanted);
        out[slot] = number ? value.value : std::nan("");
        finite = finite && (number || wanted->may_be_missing);
    }
    if (finite) {
        accept(chunk, out);
    } else {
        ++chunk.not_finite;
        skip(chunk, lines.number(), LT_TEXT("Engine", "not a finite number"));
    }
    return true;
}

bool RowReader::isText(const std::vector<Cell>& cells) const
{
    const auto isNumber = [this](Cell cell) {
        const CellKind kind = readCell(cell, layout_.style).kind;
        return kind != CellKind::Text && kind != CellKind::Empty;
    };
    const auto numbers = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), isNumber));
    return cells.empty() || (layout_.columns[0].is_number && !isNumber(cells[0]) && numbers * 2 <= cells.size()) ||
           numbers * 2 < cells.size();
}

void RowReader::judgeText(const Lines& lines, TableChunk& chunk, const std::vector<Cell>& cells) const
{
    const std::string_view line = lines.line();
    if (std::find(layout_.headings.begin(), layout_.headings.end(), line) != layout_.headings.end()) {
        ++chunk.footers;
        return skip(chunk, lines.number(), LT_TEXT("Engine", "heading"));
    }
    if (!isText(cells)) throw columnsDiffer(lines.number(), line, cells, slotOf_.size());
    if (!chunk.first_text)
        chunk.first_text = malformed(lines.number(), line, line, LT_TEXT("Engine", "a row of numbers"));
    ++chunk.footers;
    skip(chunk, lines.number(), LT_TEXT("Engine", "text below the rows"));
}

}  // namespace lathelier::io
