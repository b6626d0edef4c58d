// Files of shafts as a kind of file.
#pragma once

#include "engine/io/file_kind.h"

namespace lathelier::receptance {

/// SHAFT.json and the stock text. facts: format "shaft_json" | "stock"; details "name", "segments", "length_mm",
/// "largest_diameter_mm", "material" (what the file states).
const io::FileKind& shaftFiles();

}  // namespace lathelier::receptance
