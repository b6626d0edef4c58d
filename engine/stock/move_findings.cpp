#include "engine/stock/move_findings.h"

namespace lathelier::stock {

void MoveFindings::add(FindingKind kind, MovePath path, const StockOverlap& overlap)
{
    StockFinding& one = found_.at(static_cast<std::size_t>(kind));
    const MovePath together = one.depth_mm > 0 && one.path != path ? MovePath::Both : path;
    if (overlap.depth_mm > one.depth_mm)
        one = {0, kind, together, overlap.z_mm, overlap.x_mm, overlap.depth_mm, overlap.width_mm};
    one.path = together;
}

void MoveFindings::moveTo(std::vector<StockFinding>& all, std::int64_t line, std::int64_t& not_listed)
{
    for (StockFinding& one : found_) {
        if (!(one.depth_mm > 0)) continue;
        one.line = line;
        if (all.size() < mostFindings)
            all.push_back(one);
        else
            ++not_listed;
        one = {};
    }
}

}  // namespace lathelier::stock
