// The rows of one piece of a table: a fast way for plain rows, a thorough one for all others.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {

/// Lines passed over that are listed one by one.
inline constexpr std::size_t listedRows = 100;

/// A piece of a table's text and what became of it.
struct TableChunk {
    std::size_t begin = 0;            ///< its first line starts here
    std::size_t lines = 0;            ///< lines that start in it
    std::int64_t firstLine = 1;       ///< number of its first line in the text, from 1
    std::size_t firstRow = 0;         ///< place of its rows before gaps are closed
    std::size_t rows = 0;             ///< number of rows written out
    std::int64_t notFinite = 0;       ///< rows passed over because a wanted value is not finite
    std::int64_t skippedCount = 0;    ///< all lines passed over
    std::int64_t footers = 0;         ///< lines of text, and headings that came again
    std::vector<SkippedRow> skipped;  ///< the first `listedRows` of the lines passed over
    std::optional<Error> firstText;   ///< the first line of text: broken as soon as a row follows it
    bool rowsAfterText = false;       ///< rows behind `firstText`
    std::optional<Error> error;       ///< why reading stopped at a broken row; none: it did not
};

class RowReader {
public:
    /// Holds on to what it is given.
    RowReader(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted);

    /// Reads the lines that start in the chunk, row by row, to `out`. Errors as readRows().
    void read(TableChunk& chunk, std::size_t chunkEnd, double* out) const;

private:
    void accept(TableChunk& chunk, double*& out) const;

    /// A row of nothing but plain numbers; the place behind it, or 0 when it is anything else.
    std::size_t readPlain(std::size_t at, double* out) const;
    void skip(TableChunk& chunk, std::int64_t number, Text reason) const;
    void readThoroughly(const Lines& lines, TableChunk& chunk, std::vector<Cell>& cells, double*& out) const;

    /// A row with the right number of cells; false when it turns out to be text. Throws when it is a broken row.
    bool readCells(const Lines& lines, TableChunk& chunk, const std::vector<Cell>& cells, double*& out) const;

    /// A line that was not written as a row: its first cell, or most of its cells, are no numbers.
    bool isText(const std::vector<Cell>& cells) const;
    void judgeText(const Lines& lines, TableChunk& chunk, const std::vector<Cell>& cells) const;

    std::string_view text_;
    const TableLayout& layout_;
    const std::vector<WantedColumn>& wanted_;
    std::vector<int> slotOf_;
    bool isPlain_ = true;
};

}  // namespace lathelier::io
