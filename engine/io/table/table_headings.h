// The names and units of a table's columns, from the lines above it.
#pragma once

#include <string_view>
#include <vector>

#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// A line above the table.
struct PrefaceLine {
    std::string_view text;         ///< without the mark of a remark
    bool isRemark = false;         ///< the line began with such a mark
    std::size_t skippedIndex = 0;  ///< its place in TableLayout::skipped
};

/// How many columns the best line of names has, above rows of so many cells; 0 without one.
std::size_t countHeadings(const std::vector<PrefaceLine>& preface, char delimiter, const TableExpectation& expectation,
                          std::size_t columns);

/// Finds the line of names and the line of units, and enters them into the layout's columns.
void applyHeadings(const std::vector<PrefaceLine>& preface, const TableExpectation& expectation, TableLayout& layout);

}  // namespace lathelier::io
