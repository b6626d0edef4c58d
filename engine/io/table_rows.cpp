// Reading the rows of a table: a fast way for plain rows, a thorough one for all others, in chunks on all cores.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/io/io_codes.h"
#include "engine/io/number.h"
#include "engine/io/text_lines.h"
#include "engine/io/text_table.h"

namespace lathelier {
namespace {

constexpr std::size_t chunkBytes = std::size_t{1} << 20;
constexpr std::size_t listedRows = 100;

/// A line passed over that is an error as soon as another row follows it.
struct TextLine {
    SkippedRow row;
    std::size_t offset = 0;
};

struct Chunk {
    std::size_t begin = 0;  ///< its first line starts here
    std::size_t lines = 0;  ///< lines that start in it
    std::int64_t firstLine = 1;
    std::size_t firstRow = 0;  ///< place of its rows before gaps are closed
    std::size_t rows = 0;
    std::int64_t notFinite = 0;
    std::int64_t skippedCount = 0;
    std::int64_t footers = 0;
    std::vector<SkippedRow> skipped;
    std::optional<TextLine> firstText;  ///< the first line of text
    bool rowsBeforeText = false;
    bool rowsAfterText = false;  ///< rows behind `firstText`
    std::optional<Error> error;
};

bool endsLine(std::string_view text, std::size_t p)
{
    return text[p] == '\n' || (text[p] == '\r' && (p + 1 == text.size() || text[p + 1] != '\n'));
}

/// Ends of lines in [begin, end). Counted in short blocks, which the compiler turns into vector code.
std::size_t countLineEnds(std::string_view text, std::size_t begin, std::size_t end)
{
    std::size_t count = 0;
    std::size_t p = begin;
    while (p + 128 < end) {
        unsigned char block = 0;
        for (std::size_t i = 0; i < 128; ++i) {
            const int lf = text[p + i] == '\n';
            const int lone = static_cast<int>(text[p + i] == '\r') & static_cast<int>(text[p + i + 1] != '\n');
            block = static_cast<unsigned char>(block + (lf | lone));
        }
        count += block;
        p += 128;
    }
    for (; p < end; ++p) count += endsLine(text, p);
    return count;
}

class RowReader {
public:
    RowReader(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted)
        : text_(text), layout_(layout), wanted_(wanted), slotOf_(layout.columns.size(), -1)
    {
        for (std::size_t i = 0; i < wanted.size(); ++i) slotOf_[wanted[i].column] = static_cast<int>(i);
        // With a comma for both, only the thorough way sees which is which.
        isPlain_ = layout.style.delimiter != layout.style.decimal &&
                   std::all_of(layout.columns.begin(), layout.columns.end(),
                               [](const TableColumn& column) { return column.isNumber; });
    }

    /// Reads the lines that start in the chunk.
    void read(Chunk& chunk, std::size_t chunkEnd, double* out) const
    {
        Lines lines(text_, chunk.begin, chunk.firstLine);
        std::size_t at = chunk.begin;
        std::int64_t number = chunk.firstLine;
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

private:
    void accept(Chunk& chunk, double*& out) const
    {
        out += wanted_.size();
        ++chunk.rows;
        (chunk.firstText ? chunk.rowsAfterText : chunk.rowsBeforeText) = true;
    }

    /// A row of nothing but plain numbers; the place behind it, or 0 when it is anything else.
    std::size_t readPlain(std::size_t at, double* out) const
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
                if (!(std::abs(value) <= wanted_[static_cast<std::size_t>(slot)].largest) || std::isinf(value))
                    return 0;
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

    void skip(Chunk& chunk, std::int64_t number, Text reason) const
    {
        ++chunk.skippedCount;
        if (chunk.skipped.size() < listedRows) chunk.skipped.push_back({number, reason});
    }

    void readThoroughly(const Lines& lines, Chunk& chunk, std::vector<Cell>& cells, double*& out) const
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

    /// A row with the right number of cells; false when it turns out to be text. Throws when it is a broken row.
    bool readCells(const Lines& lines, Chunk& chunk, const std::vector<Cell>& cells, double*& out) const
    {
        bool finite = true;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            if (!layout_.columns[k].isNumber) continue;
            const CellValue value = readCell(cells[k], layout_.style);
            const int slot = slotOf_[k];
            const WantedColumn* const wanted = slot >= 0 ? &wanted_[static_cast<std::size_t>(slot)] : nullptr;
            if (value.kind == CellKind::Ambiguous) throw ambiguousNumber(lines.number(), lines.line(), cells[k]);
            const bool missing = value.kind == CellKind::Empty && (!wanted || wanted->mayBeMissing);
            if (value.kind == CellKind::Text || (value.kind == CellKind::Empty && !missing)) {
                if (isText(cells)) return false;
                throw malformed(lines.number(), lines.line(), cells[k], LT_TEXT("Engine", "a number"));
            }
            if (!wanted) continue;
            const bool number = value.kind == CellKind::Number && std::isfinite(value.value);
            if (value.kind == CellKind::Number && std::abs(value.value) > wanted->largest)
                throw tooLarge(lines, cells[k], *wanted);
            out[slot] = number ? value.value : std::nan("");
            finite = finite && (number || wanted->mayBeMissing);
        }
        if (finite) {
            accept(chunk, out);
        } else {
            ++chunk.notFinite;
            skip(chunk, lines.number(), LT_TEXT("Engine", "not a finite number"));
        }
        return true;
    }

    static Error tooLarge(const Lines& lines, Cell cell, const WantedColumn& wanted)
    {
        const Error place = malformed(lines.number(), lines.line(), cell, {});
        return Error(errors::coordinateTooLarge, {{"line", lines.number()},
                                                  {"column", *find(place.values(), "column")},
                                                  {"found", std::string(cell)},
                                                  {"maximum", wanted.largest}});
    }

    /// A line that was not written as a row: its first cell, or most of its cells, are no numbers.
    bool isText(const std::vector<Cell>& cells) const
    {
        const auto isNumber = [this](Cell cell) {
            const CellKind kind = readCell(cell, layout_.style).kind;
            return kind != CellKind::Text && kind != CellKind::Empty;
        };
        const auto numbers = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), isNumber));
        return cells.empty() || (layout_.columns[0].isNumber && !isNumber(cells[0]) && numbers * 2 <= cells.size()) ||
               numbers * 2 < cells.size();
    }

    void judgeText(const Lines& lines, Chunk& chunk, const std::vector<Cell>& cells) const
    {
        const std::string_view line = lines.line();
        if (std::find(layout_.headings.begin(), layout_.headings.end(), line) != layout_.headings.end()) {
            ++chunk.footers;
            return skip(chunk, lines.number(), LT_TEXT("Engine", "heading"));
        }
        if (!isText(cells)) throw columnsDiffer(lines.number(), line, cells, slotOf_.size());
        if (!chunk.firstText) chunk.firstText = TextLine{{lines.number(), {}}, lines.offset()};
        ++chunk.footers;
        skip(chunk, lines.number(), LT_TEXT("Engine", "text below the rows"));
    }

    std::string_view text_;
    const TableLayout& layout_;
    const std::vector<WantedColumn>& wanted_;
    std::vector<int> slotOf_;
    bool isPlain_ = true;
};

/// Rows that can start in a chunk: a row has a byte for each column at least.
std::size_t mostRows(const Chunk& chunk, const TableLayout& layout)
{
    return std::min(chunk.lines, chunkBytes / std::max<std::size_t>(layout.columns.size(), 1) + 1);
}

/// Where the lines of each chunk start, and how many there are.
std::vector<Chunk> cutIntoChunks(std::string_view text, const TableLayout& layout, const Progress& progress)
{
    const std::size_t body = layout.bodyOffset;
    const std::size_t size = text.size() - body;
    std::vector<Chunk> chunks((size + chunkBytes - 1) / chunkBytes);
    parallelFor(size, chunkBytes, progress, [&](std::size_t begin, std::size_t end) {
        Chunk& chunk = chunks[begin / chunkBytes];
        // A line starts behind each line end, so the ends are looked for one byte earlier.
        const std::size_t from = body + begin;
        std::size_t start = from;
        if (begin > 0 && !endsLine(text, from - 1)) {
            while (start < body + end && !endsLine(text, start)) ++start;
            ++start;  // without a line end, it is behind this chunk: no line starts in it
        }
        chunk.begin = start;
        chunk.lines =
            begin == 0 ? 1 + countLineEnds(text, body, body + end - 1) : countLineEnds(text, from - 1, body + end - 1);
    });
    std::int64_t line = layout.bodyLine;
    std::size_t row = 0;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        chunks[i].firstLine = line;
        chunks[i].firstRow = row;
        line += static_cast<std::int64_t>(chunks[i].lines);
        row += mostRows(chunks[i], layout);
    }
    return chunks;
}

/// A line of text with rows behind it is a broken row.
void checkText(std::string_view text, const std::vector<Chunk>& chunks)
{
    const TextLine* first = nullptr;
    for (const Chunk& chunk : chunks) {
        const bool rowsFollow = first ? chunk.rows > 0 : chunk.firstText && chunk.rowsAfterText;
        if (!first && chunk.firstText) first = &*chunk.firstText;
        if (first && rowsFollow) {
            Lines lines(text, first->offset, first->row.line);
            lines.next();
            throw malformed(lines.number(), lines.line(), lines.line(), LT_TEXT("Engine", "a row of numbers"));
        }
    }
}

}  // namespace

TableRows readRows(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                   const std::function<double*(std::size_t rows)>& allocate, const Progress& progress)
{
    std::vector<Chunk> chunks = cutIntoChunks(text, layout, progress);
    const std::size_t width = wanted.size();
    const std::size_t capacity = chunks.empty() ? 0 : chunks.back().firstRow + mostRows(chunks.back(), layout);
    double* const values = allocate(capacity);
    const RowReader reader(text, layout, wanted);
    std::atomic<std::size_t> firstBroken{chunks.size()};
    std::atomic<std::size_t> done{0};
    const std::size_t size = text.size() - layout.bodyOffset;
    parallelFor(size, chunkBytes, progress, [&](std::size_t begin, std::size_t end) {
        const std::size_t index = begin / chunkBytes;
        if (index > firstBroken.load()) return;  // only the first broken row is reported
        Chunk& chunk = chunks[index];
        try {
            reader.read(chunk, layout.bodyOffset + end, values + chunk.firstRow * width);
        } catch (const Error& error) {
            chunk.error = error;
            std::size_t known = firstBroken.load();
            while (index < known && !firstBroken.compare_exchange_weak(known, index)) {
            }
        }
        progress.report(static_cast<double>(++done) / static_cast<double>(chunks.size()));
    });
    const std::size_t broken = firstBroken.load();
    if (broken < chunks.size()) {
        // Text above the broken row in the same or an earlier chunk, with rows behind it, came first.
        checkText(text, {chunks.begin(), chunks.begin() + static_cast<std::ptrdiff_t>(broken) + 1});
        throw *chunks[broken].error;
    }
    checkText(text, chunks);

    TableRows result;
    for (const Chunk& chunk : chunks) {
        const double* const from = values + chunk.firstRow * width;
        if (chunk.firstRow != result.rows) std::copy(from, from + chunk.rows * width, values + result.rows * width);
        result.rows += chunk.rows;
        result.notFinite += chunk.notFinite;
        result.footers += chunk.footers;
        result.skippedCount += chunk.skippedCount;
        for (const SkippedRow& row : chunk.skipped)
            if (result.skipped.size() < listedRows) result.skipped.push_back(row);
    }
    const std::int64_t found = static_cast<std::int64_t>(result.rows) + result.notFinite;
    const std::int64_t lastLine =
        layout.bodyLine - 1 +
        std::accumulate(chunks.begin(), chunks.end(), std::int64_t{0}, [](std::int64_t sum, const Chunk& chunk) {
            return sum + static_cast<std::int64_t>(chunk.lines);
        });
    if (layout.announcedRows && *layout.announcedRows > found)
        throw Error(errors::truncated, {{"line", lastLine},
                                        {"column", std::int64_t{1}},
                                        {"found", found},
                                        {"expected", *layout.announcedRows},
                                        {"items", LT_TEXT("Engine", "rows")}});
    return result;
}

}  // namespace lathelier
