// The table of differences beside the title block: nominal sizes that stand in place of measured ones.
#pragma once

#include <vector>

#include "engine/drawing/drawing.h"
#include "engine/drawing/size_texts.h"

namespace lathelier::drawing {

/// Left of the title block where the sheet is wide enough, else above it; in columns as high as the block is. Empty
/// without differences.
Drawing differenceTable(const std::vector<Difference>& differences, const DrawingOptions& options, Sheet sheet,
                        double block_height_mm);

}  // namespace lathelier::drawing
