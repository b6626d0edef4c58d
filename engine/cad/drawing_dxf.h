// A technical drawing as DXF, in millimetres on paper.
#pragma once

#include "engine/cad/dxf_writer.h"
#include "engine/drawing/drawing.h"

namespace lathelier::cad {

/// All entities on the layers of dxf_writer.h; a frame and title block on "TEXT".
DxfDrawing dxfOf(const drawing::Drawing& drawing);

}  // namespace lathelier::cad
