// Tables of numbers in text files, whatever their separators, decimal marks, headings and remarks: clouds, probe
// records, profiles, frequency responses. The layout is determined from a sample; table_rows.h reads the rows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/import.h"
#include "engine/io/table/table_style.h"
#include "engine/io/text/units.h"

namespace lathelier::io {

/// Expectations of the caller.
struct TableExpectation {
    std::size_t minimum_columns = 1;  ///< least number of numeric columns
    /// True for headings (lower case, without unit) known to the caller; selects the line of column names.
    std::function<bool(const std::string& name)> knows_name;
    /// True for words that are units in a row of units; empty: units of length.
    std::function<bool(std::string_view word)> knows_unit;
};

struct TableColumn {
    std::string name;                 ///< lower case, without unit; empty when the file names no columns
    std::string heading;              ///< as written, with the unit: "marker_V", "X3 (mm)"
    std::string unit_text;            ///< unit in a row of units, as written: "V"
    std::optional<LengthScale> unit;  ///< from the heading, a row of units, or after the numbers
    bool is_number = true;            ///< false: text such as a point's label
    bool is_count = false;            ///< integers increasing by one: a row number
    bool has_decimal_marks = false;   ///< true: some of its numbers have a decimal mark
    bool is_grid_index = false;       ///< one of the first two columns, whole numbers that walk a grid row by row
};

/// Layout of a table before its rows are read.
struct TableLayout {
    TableStyle style;                            ///< separator and decimal mark
    std::vector<TableColumn> columns;            ///< in the order of the file
    bool has_names = false;                      ///< true: a line above the table names the columns
    std::optional<LengthScale> unit;             ///< stated in a remark or above the table
    std::optional<std::int64_t> announced_rows;  ///< number of rows announced by a single integer above the table
    std::size_t body_offset = 0;                 ///< offset of the first row
    std::int64_t body_line = 1;                  ///< line of the first row, from 1
    std::vector<SkippedRow> skipped;             ///< the lines above the first row
    std::vector<std::string> headings;           ///< texts of headings, which may be repeated between rows
};

/// Errors numberAmbiguous, malformed (a row with too few columns, a malformed row above the table), formatUnknown (no
/// rows of numbers at all). All with `line` and `column`.
TableLayout findLayout(std::string_view text, const TableExpectation& expectation, const ImportOptions& options);

/// Throws malformed for a row with the wrong number of columns (`found_columns`, `expected_columns`), at its end or at
/// the first cell too many.
Error columnsDiffer(std::int64_t number, std::string_view line, const std::vector<Cell>& cells, std::size_t expected);

/// For FileFacts: "comma", "space", "tab"…
std::string delimiterName(const TableStyle& style);
std::string decimalName(const TableStyle& style);

}  // namespace lathelier::io
