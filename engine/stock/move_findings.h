// The findings of one move while it is tested.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/stock/stock_check.h"

namespace lathelier::stock {

/// Keeps the deepest finding of each kind and the paths on which it occurs.
class MoveFindings {
public:
    void add(FindingKind kind, MovePath path, const StockOverlap& overlap);

    /// Appends them with the line of the move, up to mostFindings in all, counts the others, and clears.
    void moveTo(std::vector<StockFinding>& all, std::int64_t line, std::int64_t& not_listed);

private:
    std::array<StockFinding, 4> found_;  // by kind
};

}  // namespace lathelier::stock
