// A shaft in any of the forms that verbs take.
#pragma once

#include <string_view>

#include "engine/core/error.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cli {

/// STEP, SHAFT.json or a table as CSV, distinguished by content; bores as they are stated. `facts` gets `format` and,
/// of STEP, `axis`, `solid_volume_mm3`, `other_faces`. Errors of cad::readStep(), io::readShaft(), cad::readShaftCsv().
Shaft readAnyShaft(std::string_view bytes, Notes& notes, Json& facts, const Progress& progress);

/// Is it a STEP file or a SHAFT.json (an object with `segments`), and so no scan?
bool isDrawnShaft(std::string_view bytes);

}  // namespace lathelier::cli
