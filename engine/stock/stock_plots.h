// Stock as a chart, for screen and paper.
#pragma once

#include <optional>

#include "engine/report/chart.h"
#include "engine/stock/drawn_path.h"
#include "engine/stock/stock_check.h"

namespace lathelier::stock {

/// What is drawn besides the stock.
struct StockPlotParts {
    const DrawnPath* path = nullptr;  ///< of the tip, rapid moves dashed; null: none
    PathWindow window{};              ///< of the path
    std::optional<std::size_t> pass;  ///< the stock after this one, as if the program ended there; none: after all
};

/// The meridian plane in one scale: the stock before (shaded), its outline after each pass that was kept, at most
/// mostDrawnPasses of them with the last, what is left (shaded), chuck and tailstock, findings as marks.
report::Plot stockPlot(const StockResult& result, const StockPlotParts& parts = {}, const Language& language = {});

inline constexpr std::size_t mostDrawnPasses = 40;
inline constexpr std::size_t mostDrawnFindings = 20;

}  // namespace lathelier::stock
