// Header entries above the table of a measurement file: "# rpm=975; D_mm=50", "Filter: 1-50 UPR".
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/value.h"

namespace lathelier::io {

/// The key=value pairs above byte `body_offset`, as written (strings), in their order; the last of equal keys counts.
/// Several may stand on a line, separated by semicolons, or by commas in front of another key=. At most 200 are kept,
/// and none longer than 1000 bytes.
Values readHeaderLines(std::string_view text, std::size_t bodyOffset);

/// The value of `key`, case-insensitive; nullptr when missing.
const std::string* headerWord(const Values& header, std::string_view key);

/// The leading number of the value of `key` ("3.07e-05 (channel k…)", "50,5", "975 rpm"); none without one and for
/// ambiguous numbers ("1,234").
std::optional<double> headerNumber(const Values& header, std::string_view key);

}  // namespace lathelier::io
