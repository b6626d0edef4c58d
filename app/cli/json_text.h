// JSON as text that people can read too.
#pragma once

#include <string>

#include "engine/core/json.h"

namespace lathelier::cli {

/// Objects on lines of their own, arrays of plain values on one line; full double precision, decimal point, numbers
/// that do not exist as null, bytes that are no UTF-8 replaced. Ends with a line feed.
std::string toText(const Json& json);

}  // namespace lathelier::cli
