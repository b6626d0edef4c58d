// The deflection correction of a program, as radii added to the nominal contour.
#pragma once

#include <string>

#include "engine/gcode/stated_correction.h"

namespace lathelier::cam {

/// What `deflection --compensate --json` writes: `nodes` [{`z_mm`, `x_mm`, `programmed_mm`}…], in
/// the order of gcode::correctionOf(). The correction is x - programmed. Errors with line and column: malformed,
/// keyMissing.
gcode::StatedCorrection readCorrection(const std::string& json);

}  // namespace lathelier::cam
