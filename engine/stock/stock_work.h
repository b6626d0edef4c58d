// Step sizes that bound the computing time of a simulation.
#pragma once

#include <span>

#include "engine/gcode/move.h"
#include "engine/stock/stock_check.h"

namespace lathelier::stock {

inline constexpr double arcChord_mm = 0.005;
inline constexpr double mostWork = 6e8;  ///< visits of a column by feed moves; a few nanoseconds each

/// Columns and steps of feed moves, as used.
struct StockSteps {
    double column_mm = 0;
    double feed_mm = 0;
};

/// Those of the parameters, doubled until the visits of all feed moves are no more than mostWork. `tool_width_mm`:
/// extent along z of insert and holder.
StockSteps stepsFor(double stock_length_mm, std::span<const gcode::Move> moves, double tool_width_mm,
                    const StockParameters& parameters);

}  // namespace lathelier::stock
