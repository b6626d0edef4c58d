// SPINDLE.json: the chuck face of a machine, as springs or as a table of receptances.
//   {"springs": {"radial_N_mm", "tilt_N_mm_rad", "loss_factor"}}
//   {"frequency_hz": […], "H_mm_N": [[re, im]…], "L_mm_Nmm": [[re, im]…], "P_rad_Nmm": [[re, im]…]}
#pragma once

#include <string>

#include "engine/core/error.h"
#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::receptance {

/// Errors with line and column: malformed (no JSON, wrong types, both forms at once, lists of different lengths,
/// frequencies that do not ascend), keyMissing, keyOutOfRange. Note unknownKey.
SpindleReceptance readSpindle(const std::string& text, Notes& notes);

/// Writes the text such that readSpindle() restores the same bits.
std::string spindleText(const SpindleReceptance& spindle);

}  // namespace lathelier::receptance
