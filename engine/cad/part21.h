// The grammar of a STEP file (ISO 10303-21), checked before a CAD kernel reads it, as kernels do not handle malformed
// files safely.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "engine/core/progress.h"

namespace lathelier::cad {

/// Limits of accepted files.
inline constexpr std::size_t largestStep_bytes = std::size_t{64} << 20;
inline constexpr std::int64_t mostStepFaces = 20000;

struct Part21 {
    std::map<std::int64_t, std::int64_t> line_of_record;  ///< by number; lines from 1
    std::map<std::string, std::int64_t> count_of_kind;    ///< number of records of each keyword
};

/// Checks that the text is one complete file: header and data, records well formed, every number in a sane range, every
/// reference to a record of the file, no cyclic references, reference depth at most 200. Errors fileEmpty,
/// formatUnknown; malformed with `line` and `column`; stepTooLarge. Linear in the size. Throws Cancelled.
Part21 checkPart21(std::string_view text, const Progress& progress = {});

}  // namespace lathelier::cad
