// What `deflection --compensate --json` says of a corrected program, as a correction of the drawing.
#pragma once

#include <string>

#include "engine/cam/check/drawn_contour.h"

namespace lathelier::cam {

/// `nodes` [{`z_mm`, `x_mm`, `programmed_mm`}…]: corners of all corrected runs one after the other, each run from the
/// free end toward the chuck. The correction is x - programmed, straight between the corners of a run; where runs
/// overlap, the last one counts. Errors with line and column: malformed, keyMissing.
StatedCorrection readCorrection(const std::string& json);

}  // namespace lathelier::cam
