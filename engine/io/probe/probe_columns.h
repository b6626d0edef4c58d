// Columns of a probe record in a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/io/table/table_layout.h"
#include "engine/io/text/quantity.h"

namespace lathelier::io {

/// Normalised name without blanks and punctuation, ASCII letters in lower case: "X 3" and "x_3" are "x3".
std::string plainName(std::string_view name);

/// True for plain names of row numbers: "i", "index", "nr"…
bool isIndexName(const std::string& plain);

/// True for names (without unit) specific to probe records: "marker", "X3", "Yp", "ch 2"… and for times.
bool isProbeName(std::string_view name);

/// True when the headings are those of a probe record: two of the paper's four probes, two signals (a marker, numbered
/// channels, voltages), or one with times. Coordinates with times are not a probe record.
bool hasProbeNames(const TableLayout& layout);

/// Role of a column of a record.
struct ProbeColumn {
    enum class Role { Signal, Time, Index, Section, Position, Angle, Text };
    Role role = Role::Signal;          ///< role of the values
    std::string name;                  ///< as written, without the unit
    std::optional<QuantityUnit> unit;  ///< stated by the heading or a row of units; none: not stated
    std::string unit_text = {};        ///< in the place of a unit, when it is none that is known
};

/// All columns of the layout, in their order.
std::vector<ProbeColumn> findProbeColumns(const TableLayout& layout);

/// Expectation for findLayout().
TableExpectation probeExpectation();

}  // namespace lathelier::io
