// The rows of one piece of a table: a fast parser for plain rows, a general one for all others.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {

/// Largest number of skipped lines listed individually.
inline constexpr std::size_t listedRows = 100;

/// A chunk of a table's text with the result of reading it.
struct TableChunk {
    std::size_t begin = 0;            ///< start of its first line
    std::size_t lines = 0;            ///< number of lines that start in it
    std::int64_t first_line = 1;      ///< line number of its first line in the text, from 1
    std::size_t first_row = 0;        ///< index of its first row before gaps are closed
    std::size_t rows = 0;             ///< number of rows written out
    std::int64_t not_finite = 0;      ///< rows skipped because a wanted value is not finite
    std::int64_t skipped_count = 0;   ///< number of skipped lines
    std::int64_t footers = 0;         ///< lines of text and repeated headings
    std::vector<SkippedRow> skipped;  ///< the first `listedRows` skipped lines
    std::optional<Error> first_text;  ///< error at the first line of text, raised when a row follows
    bool rows_after_text = false;     ///< true: rows follow `first_text`; `first_text`
    std::optional<Error> error;       ///< error at a malformed row; none: reading completed
};

class RowReader {
public:
    /// Keeps references to its arguments.
    RowReader(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted);

    /// Reads the lines that start in the chunk, row by row, to `out`. Errors as readRows().
    void read(TableChunk& chunk, std::size_t chunkEnd, double* out) const;

private:
    void accept(TableChunk& chunk, double*& out) const;

    /// A row of nothing but plain numbers; position after it, or 0 when it is anything else.
    std::size_t readPlain(std::size_t at, double* out) const;
    void skip(TableChunk& chunk, std::int64_t number, Text reason) const;
    void readThoroughly(const Lines& lines, TableChunk& chunk, std::vector<Cell>& cells, double*& out) const;

    /// A row with the right number of cells; false when it is text. Throws for a malformed row.
    bool readCells(const Lines& lines, TableChunk& chunk, const std::vector<Cell>& cells, double*& out) const;

    /// Whether a line is text and not a row: its first cell, or most of its cells, are not numbers.
    bool isText(const std::vector<Cell>& cells) const;
    void judgeText(const Lines& lines, TableChunk& chunk, const std::vector<Cell>& cells) const;

    std::string_view text_;
    const TableLayout& layout_;
    const std::vector<WantedColumn>& wanted_;
    std::vector<int> slotOf_;
    bool isPlain_ = true;
};

}  // namespace lathelier::io
