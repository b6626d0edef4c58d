// The chuck face of a machine as an item of the project: made in one panel, used in others.
#pragma once

#include <optional>

#include "engine/core/value.h"
#include "engine/receptance/spindle/spindle_receptance.h"

namespace lathelier::receptance {

inline constexpr const char* spindleItem = "spindle";  ///< kind of the item

/// Springs: those of fields<SpindleSprings>(). A table: frequency_hz, H_real_mm_N, H_imag_mm_N, L_real_mm_Nmm,
/// L_imag_mm_Nmm, P_real_rad_Nmm, P_imag_rad_Nmm. Error linesTooMany for more lines than a project file holds.
Values toValues(const SpindleReceptance& spindle);

/// The inverse; none when the values are not those of a spindle.
std::optional<SpindleReceptance> spindleOf(const Values& values);

}  // namespace lathelier::receptance
