// Stock as a chart, for screen and paper.
#pragma once

#include <span>

#include "engine/report/chart.h"
#include "engine/stock/stock_check.h"

namespace lathelier::stock {

/// The meridian plane in one scale: the stock before (shaded), its outline after each pass that was kept, at most
/// mostDrawnPasses of them with the last, what is left (shaded), chuck and tailstock, findings as marks. With `moves`
/// the path of the tip too, rapid moves dashed.
report::Plot stockPlot(const StockResult& result, std::span<const gcode::Move> moves = {},
                       const Language& language = {});

inline constexpr std::size_t mostDrawnPasses = 40;
inline constexpr std::size_t mostDrawnFindings = 20;

}  // namespace lathelier::stock
