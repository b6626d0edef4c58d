// Detection of the separator and decimal mark of a text table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/io/import.h"
#include "engine/io/table/table_cell.h"

namespace lathelier::io {

/// A line of the sample for style detection.
struct SampleLine {
    std::string_view text;    ///< text without line end
    std::int64_t number = 0;  ///< line number, from 1
    std::size_t offset = 0;   ///< byte at which the line begins
};

/// Finds separator and decimal mark from a sample. `whole` is searched when all decimal marks of the sample could be
/// grouping marks. The rows of the table are the sample's lines with `columns` cells; 0 when there are none. Error
/// numberAmbiguous (`line`, `column`, `found`, `first`, `second`).
struct StyleFound {
    TableStyle style;         ///< separator and decimal mark
    std::size_t columns = 0;  ///< cells in a row of the table; 0: there are no rows
};
StyleFound findStyle(const std::vector<SampleLine>& sample, std::string_view whole, std::size_t minimumColumns,
                     const ImportOptions& options);

/// Possible meanings of commas between digits.
enum class CommaMeaning { Decimal, Grouping, Unknown };

/// Looks at every comma between digits in `text`; the first unambiguous one decides.
CommaMeaning meaningOfCommas(std::string_view text);

}  // namespace lathelier::io
