#include "engine/io/table/table_facts.h"

#include "engine/io/io_codes.h"
#include "engine/io/table/column_names.h"
#include "engine/io/table/row_reader.h"

namespace lathelier::io {

void describeTable(const TableLayout& layout, const TableRows& rows, const std::string& encoding, FileFacts& facts,
                   Notes& notes)
{
    facts.encoding = encoding;
    if (layout.columns.size() > 1) facts.delimiter = delimiterName(layout.style);
    facts.decimal = decimalName(layout.style);
    facts.columns = static_cast<std::int64_t>(layout.columns.size());
    facts.rows = static_cast<std::int64_t>(rows.rows);
    facts.skipped = layout.skipped;
    facts.skipped.insert(facts.skipped.end(), rows.skipped.begin(), rows.skipped.end());
    if (facts.skipped.size() > listedRows) facts.skipped.resize(listedRows);
    if (rows.footers > 0) notes.push_back({notes::rowsSkipped, {{"count", rows.footers}}});
    const std::int64_t read = static_cast<std::int64_t>(rows.rows) + rows.not_finite;
    if (layout.announced_rows && *layout.announced_rows < read)
        notes.push_back({notes::countDiffers, {{"announced", *layout.announced_rows}, {"found", read}}});
}

void noteColumns(const TableLayout& layout, std::span<const std::size_t> columns, FileFacts& facts, Notes& notes)
{
    const std::string names = namesOf(layout, columns);
    set(facts.details, "column_names", names);
    notes.push_back({notes::columnsRead, {{"columns", names}}});
}

std::int64_t countSkipped(const TableLayout& layout, const TableRows& rows)
{
    return rows.skipped_count + static_cast<std::int64_t>(layout.skipped.size());
}

std::int64_t lineOfRow(const TableLayout& layout, const TableRows& rows, std::size_t index)
{
    std::int64_t line = layout.body_line + static_cast<std::int64_t>(index);
    for (const SkippedRow& row : rows.skipped)
        if (row.line <= line) ++line;
    return line;
}

void finishTableNotes(const TableLayout& layout, const TableRows& rows, const std::string& path, FileFacts& facts,
                      Notes& notes)
{
    facts.path = path;
    const std::int64_t skipped = countSkipped(layout, rows);
    if (skipped > static_cast<std::int64_t>(facts.skipped.size())) set(facts.details, "skipped_rows", skipped);
    if (rows.not_finite > 0) notes.push_back({notes::pointsNotFinite, {{"count", rows.not_finite}}});
    for (Note& note : notes)
        if (!find(note.values, "path")) set(note.values, "path", path);
}

}  // namespace lathelier::io
