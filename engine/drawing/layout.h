// The view of a shaft with its dimensions at one scale, its origin on the axis at the free end.
#pragma once

#include "engine/drawing/drawing.h"
#include "engine/drawing/features.h"

namespace lathelier::drawing {

/// `shaft` with its bores stated (withStatedBores), `features` of it; lettering `height_mm` high.
Drawing layOut(const Shaft& shaft, const Features& features, double factor, double height_mm);

}  // namespace lathelier::drawing
