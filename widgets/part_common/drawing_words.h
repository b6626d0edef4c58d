// What the title block and the numbers of a drawing take from the screen's language and the clock.
#pragma once

#include <string>

#include "engine/core/texts.h"

namespace lathelier::part_common {

/// The date of today as ISO 8601 has it.
std::string today();

/// Of numbers in this language.
std::string decimalSeparator(const Language& language);

}  // namespace lathelier::part_common
