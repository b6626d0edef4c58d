#include "engine/cam/check/tool_changes.h"

#include <algorithm>
#include <cmath>

#include "engine/cam/cam_codes.h"

namespace lathelier::cam {
namespace {

/// From a point to the box from the axis up to `radius_mm` between two z.
double distanceToBox(const stock::Corner& at, double from_z_mm, double to_z_mm, double radius_mm)
{
    const double along = std::max({from_z_mm - at.z_mm, at.z_mm - to_z_mm, 0.0});
    return std::hypot(along, std::max(at.x_mm - radius_mm, 0.0));
}

}  // namespace

Notes toolChangesNearWork(const std::vector<gcode::Move>& moves, const stock::StockParameters& bodies,
                          double stock_length_mm, double stock_radius_mm)
{
    std::vector<stock::Box> obstacles{{{0, 0}, {stock_length_mm, stock_radius_mm}}};
    if (bodies.chuck) obstacles.push_back(boxOf(regionOf(*bodies.chuck, stock_length_mm)));
    if (bodies.tailstock)
        for (const stock::ConvexPolygon& region : regionsOf(*bodies.tailstock)) obstacles.push_back(boxOf(region));
    Notes notes;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        const gcode::Move &before = moves[i - 1], &next = moves[i];
        if (before.tool == 0 || next.tool == before.tool) continue;
        if (!gcode::isKnown(before.x_mm) || !gcode::isKnown(before.z_mm)) continue;
        const stock::Corner at{bodies.z_zero_mm - before.z_mm, before.x_mm};
        double nearest = leastChangeDistance_mm;
        for (const stock::Box& box : obstacles)
            nearest = std::min(nearest, distanceToBox(at, box.low.z_mm, box.high.z_mm, box.high.x_mm));
        if (nearest < leastChangeDistance_mm)
            notes.push_back({notes::toolChangeNearWork,
                             {{"line", next.line}, {"tool", std::int64_t{next.tool}}, {"distance_mm", nearest}}});
    }
    return notes;
}

}  // namespace lathelier::cam
