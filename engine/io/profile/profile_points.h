// From the values of a table to the points of a profile.
#pragma once

#include "engine/io/profile/profile_columns.h"
#include "engine/io/profile/profile_reader.h"
#include "engine/io/table/table_layout.h"
#include "engine/io/table/table_rows.h"

namespace lathelier::io {

/// A table being converted to a profile.
struct RawProfile {
    ProfileFile file;            ///< result, filled step by step
    TableLayout layout;          ///< layout of the table
    TableRows rows;              ///< numbers of rows read and skipped
    ProfileColumnChoice choice;  ///< columns read
    std::vector<double> values;  ///< values of the chosen columns, row by row
    std::size_t width() const { return choice.columns.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * width() + column]; }
};

/// The unit that the headings of the chosen columns or the header state. Error malformed for two different ones.
std::optional<LengthScale> statedUnit(const RawProfile& raw);

/// Angles and radii, or values at even angles: determines their meaning and computes the points. Errors unitUnknown,
/// nominalRadiusMissing.
void layPolar(RawProfile& raw, const ImportOptions& import, const ProfileOptions& options, const Progress& progress);

/// Two coordinates, or three of which one is normal to the section. Errors unitUnknown, columnsUnknown.
void layXy(RawProfile& raw, const ImportOptions& import, const Progress& progress);

}  // namespace lathelier::io
