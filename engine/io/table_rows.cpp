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
constexpr std::size_t chunksAtOnce = 16;
constexpr std::size_t listedRows = 100;

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
    std::optional<Error> firstText;  ///< the first line of text: broken as soon as a row follows it
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
        if (!chunk.firstText)
            chunk.firstText = malformed(lines.number(), line, line, LT_TEXT("Engine", "a row of numbers"));
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
void checkText(const std::vector<Chunk>& chunks, std::size_t count)
{
    const Error* first = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
        const Chunk& chunk = chunks[i];
        const bool rowsFollow = first ? chunk.rows > 0 : chunk.firstText && chunk.rowsAfterText;
        if (!first && chunk.firstText) first = &*chunk.firstText;
        if (first && rowsFollow) throw *first;
    }
}

/// A table on its way, some chunks at a time.
class TableReader {
public:
    TableReader(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                const Progress& progress)
        : layout_(layout),
          progress_(progress),
          width_(wanted.size()),
          size_(text.size() - layout.bodyOffset),
          chunks_(cutIntoChunks(text, layout, progress)),
          reader_(text, layout, wanted)
    {
    }

    std::size_t chunkCount() const { return chunks_.size(); }

    /// Where the text of chunk `i` begins.
    std::size_t offsetOf(std::size_t i) const { return layout_.bodyOffset + std::min(i * chunkBytes, size_); }

    /// Rows that the chunks [first, last) may have.
    std::size_t capacity(std::size_t first, std::size_t last) const
    {
        if (first == last) return 0;
        return chunks_[last - 1].firstRow + mostRows(chunks_[last - 1], layout_) - chunks_[first].firstRow;
    }

    /// Reads the chunks [first, last) into `values`, without gaps, and gives the number of rows. Throws for the first
    /// broken row.
    std::size_t read(std::size_t first, std::size_t last, double* values)
    {
        const std::size_t base = first < last ? chunks_[first].firstRow : 0;
        std::atomic<std::size_t> firstBroken{last};
        parallelFor(last - first, 1, progress_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t index = first + begin; index < first + end; ++index) {
                if (index > firstBroken.load()) return;  // only the first broken row is reported
                Chunk& chunk = chunks_[index];
                try {
                    reader_.read(chunk, offsetOf(index + 1), values + (chunk.firstRow - base) * width_);
                } catch (const Error& error) {
                    chunk.error = error;
                    std::size_t known = firstBroken.load();
                    while (index < known && !firstBroken.compare_exchange_weak(known, index)) {
                    }
                }
                progress_.report(static_cast<double>(++done_) / static_cast<double>(chunks_.size()));
            }
        });
        const std::size_t broken = firstBroken.load();
        // Text above the broken row, with rows behind it, came first.
        checkText(chunks_, std::min(broken + 1, last));
        if (broken < last) throw *chunks_[broken].error;

        std::size_t rows = 0;
        for (std::size_t i = first; i < last; ++i) {
            const Chunk& chunk = chunks_[i];
            const double* const from = values + (chunk.firstRow - base) * width_;
            if (chunk.firstRow - base != rows) std::copy(from, from + chunk.rows * width_, values + rows * width_);
            rows += chunk.rows;
        }
        return rows;
    }

    /// What happened to all rows. Error truncated.
    TableRows summary() const;

private:
    const TableLayout& layout_;
    const Progress& progress_;
    std::size_t width_;
    std::size_t size_;
    std::vector<Chunk> chunks_;
    RowReader reader_;
    std::atomic<std::size_t> done_{0};
};

TableRows TableReader::summary() const
{
    TableRows result;
    for (const Chunk& chunk : chunks_) {
        result.rows += chunk.rows;
        result.notFinite += chunk.notFinite;
        result.footers += chunk.footers;
        result.skippedCount += chunk.skippedCount;
        for (const SkippedRow& row : chunk.skipped)
            if (result.skipped.size() < listedRows) result.skipped.push_back(row);
    }
    const std::int64_t found = static_cast<std::int64_t>(result.rows) + result.notFinite;
    const std::int64_t lastLine =
        layout_.bodyLine - 1 +
        std::accumulate(chunks_.begin(), chunks_.end(), std::int64_t{0}, [](std::int64_t sum, const Chunk& chunk) {
            return sum + static_cast<std::int64_t>(chunk.lines);
        });
    if (layout_.announcedRows && *layout_.announcedRows > found)
        throw Error(errors::truncated, {{"line", lastLine},
                                        {"column", std::int64_t{1}},
                                        {"found", found},
                                        {"expected", *layout_.announcedRows},
                                        {"items", LT_TEXT("Engine", "rows")}});
    return result;
}

}  // namespace

TableRows readRows(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                   const std::function<double*(std::size_t rows)>& allocate, const Progress& progress)
{
    TableReader reader(text, layout, wanted, progress);
    const std::size_t count = reader.chunkCount();
    reader.read(0, count, allocate(reader.capacity(0, count)));
    return reader.summary();
}

TableRows readRows(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                   const RowSink& sink, const Progress& progress)
{
    TableReader reader(text, layout, wanted, progress);
    sink.expect(reader.capacity(0, reader.chunkCount()));
    std::vector<double> values;
    for (std::size_t first = 0; first < reader.chunkCount(); first += chunksAtOnce) {
        const std::size_t last = std::min(first + chunksAtOnce, reader.chunkCount());
        values.resize(std::max(values.size(), reader.capacity(first, last) * wanted.size()));
        const std::size_t rows = reader.read(first, last, values.data());
        sink.take(values.data(), rows);
        // A line that begins in the last chunk may end behind it, but it has been read.
        if (sink.done) sink.done(reader.offsetOf(last));
    }
    return reader.summary();
}

}  // namespace lathelier
