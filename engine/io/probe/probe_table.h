// Probe records in text tables, of two shapes.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/probe/probe_columns.h"
#include "engine/io/probe/probe_reader.h"
#include "engine/io/table/table_rows.h"

namespace lathelier::io {

/// A table of a record whose rows have been read.
struct ProbeTable {
    std::string name;  ///< replaces the path in messages
    TableLayout layout;
    std::vector<ProbeColumn> columns;
    std::vector<std::size_t> read;            ///< indices of the columns read
    std::vector<std::vector<double>> values;  ///< values by column read
    TableRows rows;                           ///< numbers of rows read and skipped
    Values header;                            ///< key=value lines of the file, as written
    const ImportOptions& options;             ///< owned by the caller

    std::size_t width() const { return read.size(); }
    double at(std::size_t row, std::size_t k) const { return values[k][row]; }
    const ProbeColumn& column(std::size_t k) const { return columns[read[k]]; }
};

/// A continuous recording; moves the values out of the table. Errors columnsUnknown, malformed (decreasing times).
ProbeRecord toRawRecord(ProbeTable& table, Notes& notes, const Progress& progress);

/// Sections of averages. Errors columnsUnknown, malformed, unitUnknown.
AveragedRecord toAveragedRecord(const ProbeTable& table, const Progress& progress);

/// The unit of displacements that the header states: `unit_disp`, `unit` or a remark.
std::optional<QuantityUnit> statedDisplacementUnit(const ProbeTable& table);

/// The same, else the given one, for displacements without a unit in their headings.
std::optional<QuantityUnit> displacementUnit(const ProbeTable& table);

/// Throws malformed at a row, for an invalid value.
Error malformedRow(const ProbeTable& table, std::size_t row, std::size_t k, Text expected);

/// A table from memory. `parsed` is called with the number of bytes no longer needed.
ProbeFile readProbeTable(const std::string& name, std::string_view bytes, const ImportOptions& options = {},
                         const Progress& progress = {}, const std::function<void(std::size_t)>& parsed = {});

}  // namespace lathelier::io
