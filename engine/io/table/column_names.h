// What the names of a table's columns say, and how messages name columns.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// True for the name (without its unit) of a quantity that no coordinate is: "force", "frequency", "time", "X3".
bool isOtherQuantity(std::string_view name);

/// True when the names of these columns say that they hold something of their own ("force_N", "temp (°C)", "time"):
/// nothing that may be taken for coordinates by its place. Names such as "col 2", "field3" or "B" say nothing. Between
/// blanks the words of a title may happen to be as many as the columns, and above a lone column a title is a name:
/// there only known quantities count, and between blanks two of them.
bool saySomethingElse(const TableLayout& layout, std::span<const std::size_t> columns);

/// The columns as messages name them: by their headings, else by their numbers from 1: "angle_deg, r_mm", "1, 2".
std::string namesOf(const TableLayout& layout, std::span<const std::size_t> columns);

/// Error columnsAmbiguous at the table: several columns could each be `meaning`.
[[noreturn]] void throwAmbiguous(const TableLayout& layout, std::span<const std::size_t> candidates, Text meaning);

/// The names of all columns in one line, for messages.
std::string columnNames(const TableLayout& layout);

}  // namespace lathelier::io
