// Values in tables.
#pragma once

#include <string>

#include "engine/core/texts.h"
#include "engine/core/value.h"

namespace lathelier::report {

/// Numbers in the unit that `unit` is shown in, with `decimals` of the engine's unit, whole numbers in groups of three
/// (narrow no-break space), "–" for missing values.
std::string cellText(const Value& value, Text unit, int decimals, const Language& language);

/// A CSV cell: decimal point, full precision, empty for missing values; quoted where it contains a comma or quote.
std::string csvCell(const Value& value);

/// Whether the cell is right-aligned (numbers).
bool isNumeric(const Value& value);

/// Replaces the space between number and unit by a no-break space.
std::string keptTogether(std::string line);

}  // namespace lathelier::report
