// Language and date of the title block and the numbers of a drawing.
#pragma once

#include <string>

#include "engine/core/texts.h"

namespace lathelier::part_common {

/// Today's date in ISO 8601 format.
std::string today();

/// Number format of this language.
std::string decimalSeparator(const Language& language);

}  // namespace lathelier::part_common
