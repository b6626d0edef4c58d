// Locations in JSON text, as line and column: syntax errors and values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/json.h"

namespace lathelier::io {

/// Path from the root to a value: keys or decimal array indices.
using JsonPath = std::vector<std::string>;

/// Parses `text`. Error malformed with `line` and `column` where it is no JSON, nests deeper than 32, or has more than
/// 10 000 names in an object.
Json parseJson(std::string_view text);

/// Line and column, counted from 1, of the value at `path` in `text`, which is JSON; of its object when it is missing.
struct JsonPlace {
    std::int64_t line = 1;    ///< line number, from 1
    std::int64_t column = 1;  ///< from 1, in characters
};
JsonPlace placeOf(std::string_view text, const JsonPath& path);

/// Error malformed for the value at `path` in `text`, which is JSON: it is not what is expected there.
Error misfit(std::string_view text, const JsonPath& path, Value expected);

}  // namespace lathelier::io
