#include "widgets/turning/tool_shapes.h"

#include <algorithm>

#include "engine/stock/tool_outline.h"

namespace lathelier::turning_panel {

std::vector<QPolygonF> toolShapes(const cam::ClampingOutcome& clamping, const QPointF& tip, int number)
{
    std::vector<QPolygonF> shapes;
    if (!clamping.bare) return shapes;
    const auto& tools = clamping.bare->parameters.tools;
    const auto tool =
        std::find_if(tools.begin(), tools.end(), [number](const Tool& each) { return each.number == number; });
    if (tool == tools.end()) return shapes;
    const stock::ToolOutline outline = stock::outlineOf(*tool);  // the plan has checked it
    std::vector<stock::ConvexPolygon> bodies = outline.holders;
    bodies.push_back(outline.insert);
    for (const stock::ConvexPolygon& body : bodies) {
        QPolygonF& shape = shapes.emplace_back();
        for (const stock::Corner& corner : body) shape << tip + QPointF(corner.z_mm, corner.x_mm);
    }
    return shapes;
}

}  // namespace lathelier::turning_panel
