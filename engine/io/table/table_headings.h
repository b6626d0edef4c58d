// The names and units of a table's columns, from the lines above it.
#pragma once

#include <string_view>
#include <vector>

#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// A line above the table.
struct PrefaceLine {
    std::string_view text;          ///< without the comment mark
    bool is_remark = false;         ///< the line began with a comment mark
    std::size_t skipped_index = 0;  ///< index in TableLayout::skipped
};

/// Number of columns of the best line of names above rows with the given number of cells; 0 without one.
std::size_t countHeadings(const std::vector<PrefaceLine>& preface, char delimiter, const TableExpectation& expectation,
                          std::size_t columns);

/// Finds the line of names and the line of units, and enters them into the layout's columns.
void applyHeadings(const std::vector<PrefaceLine>& preface, const TableExpectation& expectation, TableLayout& layout);

}  // namespace lathelier::io
