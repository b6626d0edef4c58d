// Tables of numbers in text files, whatever their separators, decimal marks, headings and remarks: clouds, probe
// records, profiles, frequency responses. Their layout is found out from a sample; table_rows.h reads them.
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

/// What the caller knows beforehand.
struct TableExpectation {
    std::size_t minimumColumns = 1;  ///< of numbers
    /// True for headings (lower case, without unit) that the caller can use; picks the line of column names.
    std::function<bool(const std::string& name)> knowsName;
    /// True for words that are units in a row of units; empty: units of length.
    std::function<bool(std::string_view word)> knowsUnit;
};

struct TableColumn {
    std::string name;                 ///< lower case, without unit; empty when the file names no columns
    std::string heading;              ///< as written, with the unit: "marker_V", "X3 (mm)"
    std::string unitWord;             ///< of a row of units, as written: "V"
    std::optional<LengthScale> unit;  ///< from the heading, a row of units, or behind the numbers
    bool isNumber = true;             ///< false: text such as a point's label
    bool isCount = false;             ///< whole numbers that go up by one: a row number
    bool hasMarks = false;            ///< some of its numbers have a decimal mark
};

/// What was found out about a table before its rows are read.
struct TableLayout {
    TableStyle style;                           ///< separator and decimal mark
    std::vector<TableColumn> columns;           ///< in the order of the file
    bool hasNames = false;                      ///< a line above the table names the columns
    std::optional<LengthScale> unit;            ///< stated in a remark or above the table
    std::optional<std::int64_t> announcedRows;  ///< a lone whole number above the table
    std::size_t bodyOffset = 0;                 ///< where the first row starts
    std::int64_t bodyLine = 1;                  ///< line of the first row, from 1
    std::vector<SkippedRow> skipped;            ///< the lines above the first row
    std::vector<std::string> headings;          ///< their texts: they may come again between rows
};

/// Errors numberAmbiguous, malformed (a row with too few columns, a broken row above the table), formatUnknown (no rows
/// of numbers at all). All with `line` and `column`.
TableLayout findLayout(std::string_view text, const TableExpectation& expectation, const ImportOptions& options);

/// Error malformed for a row with the wrong number of columns (`found_columns`, `expected_columns`), at its end or at
/// the first cell too many.
Error columnsDiffer(std::int64_t number, std::string_view line, const std::vector<Cell>& cells, std::size_t expected);

/// For FileFacts: "comma", "space", "tab"…
std::string delimiterName(const TableStyle& style);
std::string decimalName(const TableStyle& style);

}  // namespace lathelier::io
