// From the values of a table to the points of a profile.
#pragma once

#include "engine/io/profile/profile_columns.h"
#include "engine/io/profile/profile_reader.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"

namespace lathelier::io {

/// A table on its way to a profile.
struct RawProfile {
    ProfileFile file;            ///< the answer, filled step by step
    TableLayout layout;          ///< of the file
    TableRows rows;              ///< how many rows were read and passed over
    ProfileColumnChoice choice;  ///< the columns that are read
    std::vector<double> values;  ///< row by row, the chosen columns
    std::size_t width() const { return choice.columns.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * width() + column]; }
};

/// The unit that the headings of the chosen columns or the header state. Error malformed for two of them.
std::optional<LengthScale> statedUnit(const RawProfile& raw);

/// Angles and radii, or values at even angles: settles what they hold and lays the points. Errors unitUnknown,
/// nominalRadiusMissing.
void layPolar(RawProfile& raw, const ImportOptions& import, const ProfileOptions& options, const Progress& progress);

/// Two coordinates, or three of which one lies across the section. Errors unitUnknown, columnsUnknown.
void layXy(RawProfile& raw, const ImportOptions& import, const Progress& progress);

}  // namespace lathelier::io
