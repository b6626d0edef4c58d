// Values in tables.
#pragma once

#include <string>

#include "engine/core/texts.h"
#include "engine/core/value.h"

namespace lathelier::report {

/// Numbers in the unit that `unit` is shown in, with `decimals` of the engine's unit, whole numbers in groups of three
/// (narrow no-break space), "–" for what does not exist.
std::string cellText(const Value& value, Text unit, int decimals, const Language& language);

/// A cell of CSV: decimal point, full precision, empty for what does not exist; quoted where a comma or quote asks it.
std::string csvCell(const Value& value);

/// Numbers are set to the right.
bool isNumeric(const Value& value);

/// A line break must not part a number from its unit: no-break spaces between them.
std::string keptTogether(std::string line);

}  // namespace lathelier::report
