// Frame and title block of a sheet (after ISO 5457 and ISO 7200: 180 mm wide, lower right corner).
#pragma once

#include "engine/drawing/drawing.h"
#include "engine/drawing/shaft_drawing.h"

namespace lathelier::drawing {

inline constexpr double titleBlockWidth_mm = 180;

/// Sets the label smaller, then shortens it, until it fits into the width.
void fitInto(Label& label, double width_mm);

/// Height of the block with these contents, mm.
double titleBlockHeight_mm(const Shaft& shaft, const DrawingOptions& options);

/// Frame and block in the coordinates of the sheet. Contents too long for their cell are set smaller, then shortened.
Drawing titleBlock(const Shaft& shaft, const DrawingOptions& options, Sheet sheet, const Scale& scale);

}  // namespace lathelier::drawing
