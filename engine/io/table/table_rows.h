// The rows of a table whose layout is known, read on all cores.
#pragma once

#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// A column to be read. A value that is not finite passes the row over, unless it may be missing (then it is NaN).
struct WantedColumn {
    std::size_t column = 0;                                    ///< place in TableLayout::columns
    double largest = std::numeric_limits<double>::infinity();  ///< larger ones are an Error coordinateTooLarge
    bool mayBeMissing = false;                                 ///< an empty cell or one that is not finite gives NaN
};

/// What happened to the rows.
struct TableRows {
    std::size_t rows = 0;             ///< written through `allocate`
    std::int64_t notFinite = 0;       ///< rows passed over because a wanted value is not finite
    std::int64_t footers = 0;         ///< lines of text below the last row, and headings that came again
    std::int64_t skippedCount = 0;    ///< all lines passed over below the first row
    std::vector<SkippedRow> skipped;  ///< the first 100 of them
};

/// Reads the wanted columns of all rows, row by row, into the place that `allocate(rows)` gives for `rows` rows at
/// most. The rows have to be as regular as the first ones: anything else but remarks, blank lines, repeated headings
/// and text below the last row is an Error malformed; fewer rows than announced is an Error truncated. The result does
/// not depend on the number of cores. Throws Cancelled.
TableRows readRows(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                   const std::function<double*(std::size_t rows)>& allocate, const Progress& progress);

/// Where rows go while a large table is read.
struct RowSink {
    /// Hears first how many rows there are at most.
    std::function<void(std::size_t rows)> expect;

    /// Gets the rows of a step, row by row and in their order.
    std::function<void(const double* values, std::size_t rows)> take;

    /// Hears up to which byte of the text the rows have been taken; may be empty.
    std::function<void(std::size_t offset)> done;
};

/// The same in steps of some megabytes of text, for tables that fill the memory.
TableRows readRows(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                   const RowSink& sink, const Progress& progress);

}  // namespace lathelier::io
