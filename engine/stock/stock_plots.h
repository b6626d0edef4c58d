// Stock as a chart, for screen and paper.
#pragma once

#include <optional>

#include "engine/report/chart.h"
#include "engine/stock/drawn_path.h"
#include "engine/stock/stock_check.h"

namespace lathelier::stock {

/// Optional parts of the plot.
struct StockPlotParts {
    const DrawnPath* path = nullptr;  ///< of the tip, rapid moves dashed; null: none
    PathWindow window{};
    std::optional<std::size_t> pass;  ///< shows the stock after this pass; none: after all
};

/// The meridian plane with equal scales: the stock before (shaded), the stored outlines after passes, at most
/// mostDrawnPasses of them with the last, remaining stock (shaded), chuck and tailstock, findings as marks.
report::Plot stockPlot(const StockResult& result, const StockPlotParts& parts = {}, const Language& language = {});

inline constexpr std::size_t mostDrawnPasses = 40;
inline constexpr std::size_t mostDrawnFindings = 20;

}  // namespace lathelier::stock
