// Marks of a shaft in its CSV: a remark for each, "# mark {"kind": "keyway", …}", with the keys of SHAFT.json.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// The remarks, without their "# ".
std::vector<std::string> markRemarks(const Shaft& shaft);

/// Marks of all remarks of a text. Errors: malformed and those of a mark in SHAFT.json, with `line` of the text.
std::vector<ShaftMark> readMarkRemarks(std::string_view text, Notes& notes);

}  // namespace lathelier::cad
