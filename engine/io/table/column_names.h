// Interpretation of column names, and column names in messages.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// True for the name (without its unit) of a quantity other than a coordinate: "force", "frequency", "time", "X3".
bool isOtherQuantity(std::string_view name);

/// True when the names of these columns denote other quantities ("force_N", "temp (°C)", "time"), which must not be
/// taken as coordinates by position. Generic names such as "col 2", "field3" or "B" do not count. With blanks as
/// separator a title may have as many words as columns, and above a single column a title looks like a name: there only
/// known quantities count, with blanks at least two of them.
bool haveNamesOfOtherQuantities(const TableLayout& layout, std::span<const std::size_t> columns);

/// Column names for messages: the headings, else the numbers from 1: "angle_deg, r_mm", "1, 2".
std::string namesOf(const TableLayout& layout, std::span<const std::size_t> columns);

/// Throws columnsAmbiguous at the table: several columns could each be `meaning`.
[[noreturn]] void throwAmbiguous(const TableLayout& layout, std::span<const std::size_t> candidates, Text meaning);

/// The names of all columns in one line, for messages.
std::string columnNames(const TableLayout& layout);

}  // namespace lathelier::io
