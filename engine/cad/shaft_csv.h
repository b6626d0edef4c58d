// A shaft as CSV, for spreadsheets: the paper's Table 1, or all rows with measured values; writing and reading.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

struct CsvStyle {
    char decimal = '.';    ///< '.' or ','
    char delimiter = ',';  ///< ',' ';' or a tab; not the decimal mark
};

/// no,x_mm,y_mm,radius_mm,z_start_mm,z_end_mm,chamfer_start_mm,chamfer_end_mm of stepsOf(); rows that are not steps
/// follow as remarks ("# row 3: …").
std::string stepsCsv(const Shaft& shaft, const CsvStyle& style = {});

/// contour (outside, bore_free, bore_chuck), no, z_start_mm, z_end_mm, then the keys of a row: length_mm,
/// start_diameter_mm, end_diameter_mm, arc_radius_mm, bore_diameter_mm, role, tolerance_class, …, measured and U.
/// Numbers are read back bit-identical. Marks follow as remarks (csv_marks.h); material and name are not in it.
std::string shaftCsv(const Shaft& shaft, const CsvStyle& style = {});

/// Reads either table by its heading, in any encoding: separator and decimal mark are detected; z_start_mm and z_end_mm
/// of the full table are not read. A chamfer of Table 1 is 45°. The rules of checkShaft() are not checked here. Errors:
/// fileEmpty, columnsUnknown (`line`), malformed (`line`, `column`). Notes: unknownKey.
Shaft readShaftCsv(std::string_view bytes, Notes& notes, const Progress& progress = {});

}  // namespace lathelier::cad
