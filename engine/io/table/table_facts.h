// What the readers of tables say of their files.
#pragma once

#include <span>

#include "engine/core/error.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"

namespace lathelier::io {

/// Enters encoding, delimiter, decimal mark, rows, columns and skipped lines into the facts, and what is to be said of
/// rows into the notes (rowsSkipped, countDiffers).
void describeTable(const TableLayout& layout, const TableRows& rows, const std::string& encoding, FileFacts& facts,
                   Notes& notes);

/// Says by name which columns are read: detail "column_names", note columnsRead.
void noteColumns(const TableLayout& layout, std::span<const std::size_t> columns, FileFacts& facts, Notes& notes);

/// All skipped lines: those of the facts and those that came after the first hundred.
std::int64_t countSkipped(const TableLayout& layout, const TableRows& rows);

/// The line of row `index` (from 0) of those that were read.
std::int64_t lineOfRow(const TableLayout& layout, const TableRows& rows, std::size_t index);

/// What the notes of a table without a reader of its own still need: pointsNotFinite, "skipped_rows", and the path.
void finishTableNotes(const TableLayout& layout, const TableRows& rows, const std::string& path, FileFacts& facts,
                      Notes& notes);

}  // namespace lathelier::io
