// Reading the rows of a table in chunks on all cores.
#include "engine/io/table/table_rows.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include "engine/core/parallel.h"
#include "engine/io/io_codes.h"
#include "engine/io/table/row_reader.h"
#include "engine/io/table/table_layout.h"

namespace lathelier::io {
namespace {

constexpr std::size_t chunkBytes = std::size_t{1} << 20;
constexpr std::size_t chunksAtOnce = 16;

bool endsLine(std::string_view text, std::size_t p)
{
    return text[p] == '\n' || (text[p] == '\r' && (p + 1 == text.size() || text[p + 1] != '\n'));
}

/// Ends of lines in [begin, end). Counted in short blocks, which are vectorised.
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

/// Upper bound of the rows in a chunk: a row has at least one byte per column.
std::size_t mostRowsOf(const TableChunk& chunk, const TableLayout& layout)
{
    return std::min(chunk.lines, chunkBytes / std::max<std::size_t>(layout.columns.size(), 1) + 1);
}

/// Start and number of the lines of each chunk.
std::vector<TableChunk> cutIntoChunks(std::string_view text, const TableLayout& layout, const Progress& progress)
{
    const std::size_t body = layout.body_offset;
    const std::size_t size = text.size() - body;
    std::vector<TableChunk> chunks((size + chunkBytes - 1) / chunkBytes);
    parallelFor(size, chunkBytes, progress, [&](std::size_t begin, std::size_t end) {
        TableChunk& chunk = chunks[begin / chunkBytes];
        // A line starts after each line end, so the search for ends begins one byte earlier.
        const std::size_t from = body + begin;
        std::size_t start = from;
        if (begin > 0 && !endsLine(text, from - 1)) {
            while (start < body + end && !endsLine(text, start)) ++start;
            ++start;  // without a line end no line starts in this chunk
        }
        chunk.begin = start;
        chunk.lines =
            begin == 0 ? 1 + countLineEnds(text, body, body + end - 1) : countLineEnds(text, from - 1, body + end - 1);
    });
    std::int64_t line = layout.body_line;
    std::size_t row = 0;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        chunks[i].first_line = line;
        chunks[i].first_row = row;
        line += static_cast<std::int64_t>(chunks[i].lines);
        row += mostRowsOf(chunks[i], layout);
    }
    return chunks;
}

/// A line of text followed by rows is a malformed row.
void checkText(const std::vector<TableChunk>& chunks, std::size_t count)
{
    const Error* first = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
        const TableChunk& chunk = chunks[i];
        const bool rowsFollow = first ? chunk.rows > 0 : chunk.first_text && chunk.rows_after_text;
        if (!first && chunk.first_text) first = &*chunk.first_text;
        if (first && rowsFollow) throw *first;
    }
}

/// Incremental reading of a table, some chunks at a time.
class TableReader {
public:
    TableReader(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                const Progress& progress)
        : layout_(layout),
          progress_(progress),
          width_(wanted.size()),
          size_(text.size() - layout.body_offset),
          chunks_(cutIntoChunks(text, layout, progress)),
          reader_(text, layout, wanted)
    {
    }

    std::size_t chunkCount() const { return chunks_.size(); }

    /// Offset of chunk `i`.
    std::size_t offsetOf(std::size_t i) const { return layout_.body_offset + std::min(i * chunkBytes, size_); }

    /// Upper bound of the rows in the chunks [first, last).
    std::size_t capacity(std::size_t first, std::size_t last) const
    {
        if (first == last) return 0;
        return chunks_[last - 1].first_row + mostRowsOf(chunks_[last - 1], layout_) - chunks_[first].first_row;
    }

    /// Reads the chunks [first, last) into `values`, without gaps, and returns the number of rows. Throws for the first
    /// malformed row.
    std::size_t read(std::size_t first, std::size_t last, double* values)
    {
        const std::size_t base = first < last ? chunks_[first].first_row : 0;
        std::atomic<std::size_t> firstBroken{last};
        parallelFor(last - first, 1, progress_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t index = first + begin; index < first + end; ++index) {
                if (index > firstBroken.load()) return;  // only the first malformed row is reported
                TableChunk& chunk = chunks_[index];
                try {
                    reader_.read(chunk, offsetOf(index + 1), values + (chunk.first_row - base) * width_);
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
        // Text followed by rows precedes the malformed row.
        checkText(chunks_, std::min(broken + 1, last));
        if (broken < last) throw *chunks_[broken].error;

        std::size_t rows = 0;
        for (std::size_t i = first; i < last; ++i) {
            const TableChunk& chunk = chunks_[i];
            const double* const from = values + (chunk.first_row - base) * width_;
            if (chunk.first_row - base != rows) std::copy(from, from + chunk.rows * width_, values + rows * width_);
            rows += chunk.rows;
        }
        return rows;
    }

    /// Totals of all chunks. Error truncated.
    TableRows summary() const;

private:
    const TableLayout& layout_;
    const Progress& progress_;
    std::size_t width_;
    std::size_t size_;
    std::vector<TableChunk> chunks_;
    RowReader reader_;
    std::atomic<std::size_t> done_{0};
};

TableRows TableReader::summary() const
{
    TableRows result;
    for (const TableChunk& chunk : chunks_) {
        result.rows += chunk.rows;
        result.not_finite += chunk.not_finite;
        result.footers += chunk.footers;
        result.skipped_count += chunk.skipped_count;
        for (const SkippedRow& row : chunk.skipped)
            if (result.skipped.size() < listedRows) result.skipped.push_back(row);
    }
    const std::int64_t found = static_cast<std::int64_t>(result.rows) + result.not_finite;
    const std::int64_t lastLine =
        layout_.body_line - 1 +
        std::accumulate(chunks_.begin(), chunks_.end(), std::int64_t{0}, [](std::int64_t sum, const TableChunk& chunk) {
            return sum + static_cast<std::int64_t>(chunk.lines);
        });
    if (layout_.announced_rows && *layout_.announced_rows > found)
        throw Error(errors::truncated, {{"line", lastLine},
                                        {"column", std::int64_t{1}},
                                        {"found", found},
                                        {"expected", *layout_.announced_rows},
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
        // A line that begins in the last chunk may end after it, and has been read.
        if (sink.done) sink.done(reader.offsetOf(last));
    }
    return reader.summary();
}

}  // namespace lathelier::io
