// Rows of a bore within the part.
#pragma once

#include <vector>

#include "engine/features/recognition.h"

namespace lathelier::features {

/// Rows in order of z, each from a smaller to a larger z within 0 and the length: what lies beyond an end of the part
/// is left out, since the walls of a bore there are those of something else.
std::vector<RecognizedRow> rowsWithinPart(std::vector<RecognizedRow> rows, double length_mm);

}  // namespace lathelier::features
