// The unit that a file's lengths are read in.
#pragma once

#include <optional>

#include "engine/core/error.h"
#include "engine/io/text/units.h"

namespace lathelier::io {

/// Coordinates beyond this are refused where they stand in the file: 10 km, as far as the registration reaches, which
/// could only say so without a line.
inline constexpr double largestCoordinate_mm = 1e7;

/// largestCoordinate_mm in the unit of the file, mm when that is still to be guessed.
double largestCoordinate(const std::optional<LengthScale>& stated, const ImportOptions& options);

/// A stated unit rules (note unitNotUsed when another is given), else the given one, else an extent of 1 to 10 000 is
/// read as mm (note unitGuessed), else Error unitUnknown. Enters `unit` and `unit_source` into the facts.
LengthScale settleUnit(const std::optional<LengthScale>& stated, const ImportOptions& options, double extent,
                       FileFacts& facts, Notes& notes);

}  // namespace lathelier::io
