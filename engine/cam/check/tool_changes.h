// Tool changes near the work. The turret is not modelled: what is known is where the tip stands when a program calls
// the next tool.
#pragma once

#include <vector>

#include "engine/core/error.h"
#include "engine/gcode/move.h"
#include "engine/stock/stock_check.h"

namespace lathelier::cam {

inline constexpr double leastChangeDistance_mm = 20;  ///< smaller distances of the tip at a tool change are noted

/// Notes toolChangeNearWork: the tip stands less than leastChangeDistance_mm from the bar, the chuck or the tailstock
/// (straight lines in the meridian plane). Changes at a reference point are not among them. At most one for each
/// change.
Notes toolChangesNearWork(const std::vector<gcode::Move>& moves, const stock::StockParameters& bodies,
                          double stock_length_mm, double stock_radius_mm);

}  // namespace lathelier::cam
