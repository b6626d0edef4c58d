// The rows of a table whose layout is known, read on all cores.
#pragma once

#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// A column to be read. A row with a non-finite value is skipped, unless the value may be missing (then it is NaN).
struct WantedColumn {
    std::size_t column = 0;                                    ///< index in TableLayout::columns
    double largest = std::numeric_limits<double>::infinity();  ///< larger magnitudes give the Error coordinateTooLarge
    bool may_be_missing = false;                               ///< true: an empty or non-finite cell gives NaN
};

/// Numbers of rows read and skipped.
struct TableRows {
    std::size_t rows = 0;             ///< rows written to the memory of `allocate`
    std::int64_t not_finite = 0;      ///< rows skipped because a wanted value is not finite
    std::int64_t footers = 0;         ///< lines of text below the last row and repeated headings
    std::int64_t skipped_count = 0;   ///< number of lines skipped below the first row
    std::vector<SkippedRow> skipped;  ///< the first 100 of them
};

/// Reads the wanted columns of all rows, row by row, into the place that `allocate(rows)` gives for `rows` rows at
/// most. The rows must have the layout of the first ones: anything except remarks, blank lines, repeated headings and
/// text below the last row gives the Error malformed; fewer rows than announced give the Error truncated. The result
/// does not depend on the number of cores. Throws Cancelled.
TableRows readRows(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                   const std::function<double*(std::size_t rows)>& allocate, const Progress& progress);

/// Receiver of the rows of a large table.
struct RowSink {
    /// Called first, with an upper bound of the number of rows.
    std::function<void(std::size_t rows)> expect;

    /// Receives the rows of a step in order.
    std::function<void(const double* values, std::size_t rows)> take;

    /// Called with the number of bytes of the text processed; may be empty.
    std::function<void(std::size_t offset)> done;
};

/// The same in steps of some megabytes of text, for tables that fill the memory.
TableRows readRows(std::string_view text, const TableLayout& layout, const std::vector<WantedColumn>& wanted,
                   const RowSink& sink, const Progress& progress);

}  // namespace lathelier::io
