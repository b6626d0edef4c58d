// The deviations of single points as a file.
#pragma once

#include <string>

#include "engine/registration/compare.h"

namespace lathelier {

/// One row for each point of the copy, in input order, in the reference's frame: x_mm, y_mm, z_mm, deviation_mm, used.
/// The extension of `path` decides: .csv (comma, decimal point, shortest digits that read back the same; an empty field
/// where there is no deviation) or .ply (binary little endian, double coordinates, float deviation, NaN where none).
/// Errors: FormatUnknown for another extension, FileNotWritable.
void writeDeviations(const std::string& path, const Scan& copy, const CompareResult& result,
                     const Progress& progress = {});

}  // namespace lathelier
