// Facts and notes common to the readers of tables.
#pragma once

#include <span>

#include "engine/core/error.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"

namespace lathelier::io {

/// Enters encoding, delimiter, decimal mark, rows, columns and skipped lines into the facts, and the notes on rows
/// (rowsSkipped, countDiffers).
void describeTable(const TableLayout& layout, const TableRows& rows, const std::string& encoding, FileFacts& facts,
                   Notes& notes);

/// Names the columns read: detail "column_names", note columnsRead.
void noteColumns(const TableLayout& layout, std::span<const std::size_t> columns, FileFacts& facts, Notes& notes);

/// Number of skipped lines, including those beyond the first hundred.
std::int64_t countSkipped(const TableLayout& layout, const TableRows& rows);

/// Line number of the row read with index `index` (from 0).
std::int64_t lineOfRow(const TableLayout& layout, const TableRows& rows, std::size_t index);

/// Completes the notes of a table without a specific reader: pointsNotFinite, "skipped_rows", and the path.
void finishTableNotes(const TableLayout& layout, const TableRows& rows, const std::string& path, FileFacts& facts,
                      Notes& notes);

}  // namespace lathelier::io
