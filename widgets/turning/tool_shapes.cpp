#include "widgets/turning/tool_shapes.h"

#include "engine/cam/drawn/stock_skin.h"

namespace lathelier::turning_panel {

std::vector<QPolygonF> toolShapes(const cam::ClampingOutcome& clamping, const QPointF& tip, int number)
{
    std::vector<QPolygonF> shapes;
    const auto outline = cam::outlineOfTool(clamping, number);
    if (!outline) return shapes;
    std::vector<stock::ConvexPolygon> bodies = outline->holders;
    bodies.push_back(outline->insert);
    for (const stock::ConvexPolygon& body : bodies) {
        QPolygonF& shape = shapes.emplace_back();
        for (const stock::Corner& corner : body) shape << tip + QPointF(corner.z_mm, corner.x_mm);
    }
    return shapes;
}

}  // namespace lathelier::turning_panel
