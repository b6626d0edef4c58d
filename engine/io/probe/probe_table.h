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
    std::string name;                         ///< stands for the path in messages
    TableLayout layout;                       ///< of the file
    std::vector<ProbeColumn> columns;         ///< of the file
    std::vector<std::size_t> read;            ///< places of the columns that were read
    std::vector<std::vector<double>> values;  ///< of each column that was read
    TableRows rows;                           ///< how many rows were read and passed over
    Values header;                            ///< key=value lines of the file, as written
    const ImportOptions& options;             ///< of the caller, who keeps them

    std::size_t width() const { return read.size(); }
    double at(std::size_t row, std::size_t k) const { return values[k][row]; }
    const ProbeColumn& column(std::size_t k) const { return columns[read[k]]; }
};

/// A continuous recording, which takes the values out of the table. Errors columnsUnknown, malformed (times that go
/// back).
ProbeRecord toRawRecord(ProbeTable& table, Notes& notes, const Progress& progress);

/// Sections of averages. Errors columnsUnknown, malformed, unitUnknown.
AveragedRecord toAveragedRecord(const ProbeTable& table, const Progress& progress);

/// The unit of displacements that the header states: `unit_disp`, `unit` or a remark.
std::optional<QuantityUnit> statedDisplacementUnit(const ProbeTable& table);

/// The same, else the given one: for displacements whose headings state none.
std::optional<QuantityUnit> displacementUnit(const ProbeTable& table);

/// Error malformed at a row, for a value that fits no record.
Error malformedRow(const ProbeTable& table, std::size_t row, std::size_t k, Text expected);

/// A table from memory. `parsed` hears from time to time how many of the bytes are not needed any more.
ProbeFile readProbeTable(const std::string& name, std::string_view bytes, const ImportOptions& options = {},
                         const Progress& progress = {}, const std::function<void(std::size_t)>& parsed = {});

}  // namespace lathelier::io
