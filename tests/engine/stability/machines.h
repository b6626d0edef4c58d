// Machines and cutting data shared by the tests of the room.
#pragma once

#include <vector>

#include "engine/stability/modes.h"

namespace lathelier::stability {

/// Paper A's example: 223 Hz, 3 %, 1e7 N/m; K_r 2e9 N/m².
inline const std::vector<Mode> paperA{{223, 0.03, 1e4}};
inline constexpr double coefficient_N_mm2 = 2000;

}  // namespace lathelier::stability
