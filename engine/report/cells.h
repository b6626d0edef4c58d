// Values in tables.
#pragma once

#include <string>

#include "engine/core/texts.h"
#include "engine/core/value.h"
#include "engine/report/document.h"

namespace lathelier {

/// Numbers with `decimals`, whole numbers in groups of three (narrow no-break space), "–" for what does not exist.
std::string cellText(const Value& value, int decimals, const Language& language);

/// Numbers are set to the right.
bool isNumeric(const Value& value);

/// "✓ within tolerance", "✗ out of tolerance", or empty without a verdict. Never colour alone.
std::string verdictText(const Headline& headline, const Language& language);

/// A line break must not part a number from its unit: no-break spaces between them.
std::string keptTogether(std::string line);

/// As many columns as the text takes on a terminal, roughly: its characters.
std::size_t characters(const std::string& text);

}  // namespace lathelier
