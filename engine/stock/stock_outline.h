// The boundary of stock as closed polylines, for drawing and for JSON.
#pragma once

#include <vector>

#include "engine/stock/meridian_stock.h"

namespace lathelier::stock {

/// One closed polyline for each connected piece of material and for each cavity within it: the first corner is repeated
/// at the end, and NaN in both lists separates two of them. Material is on the left.
struct StockOutline {
    std::vector<double> z_mm;  ///< along the axis
    std::vector<double> x_mm;  ///< radius
    friend bool operator==(const StockOutline&, const StockOutline&) = default;
};

/// Overlapping spans of neighbouring columns are connected; at a span without neighbour the outline closes half a
/// column beyond it. Corners nearer than `tolerance_mm` to the line between the kept ones are omitted (U. Ramer,
/// "An iterative procedure for the polygonal approximation of plane curves", 1972; D. Douglas, T. Peucker, 1973).
/// O(spans log spans).
StockOutline outlineOf(const MeridianStock& stock, double tolerance_mm);

}  // namespace lathelier::stock
