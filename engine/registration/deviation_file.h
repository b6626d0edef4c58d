// The deviation of every point as a file for other programs.
#pragma once

#include <string>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/compare.h"

namespace lathelier::registration {

/// True for the names writeDeviations can write: they end in .ply or .csv.
bool isDeviationFile(const std::string& path);

/// One row for each point of the copy, in input order, in the reference's frame: x_mm, y_mm, z_mm, deviation_mm, used.
/// CSV: the shortest digits that read back the same, an empty cell where there is no deviation. PLY: binary, double
/// coordinates, float deviation (NaN where there is none), uchar used. Errors: valueNotUnderstood (neither .ply nor
/// .csv), fileNotWritable. Throws Cancelled; then nothing is left behind.
void writeDeviations(const std::string& path, const Scan& copy, const CompareResult& result,
                     const Progress& progress = {});

}  // namespace lathelier::registration
