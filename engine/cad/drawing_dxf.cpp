#include "engine/cad/drawing_dxf.h"

namespace lathelier::cad {
namespace {

std::string layerOf(drawing::Layer layer)
{
    switch (layer) {
        case drawing::Layer::Contour: return layers::contour;
        case drawing::Layer::Axis: return layers::axis;
        case drawing::Layer::Hatch: return layers::hatch;
        case drawing::Layer::Dimensions: return layers::dimensions;
        case drawing::Layer::Text:
        case drawing::Layer::Frame: return layers::text;
    }
    return layers::text;
}

DxfText::Align alignOf(drawing::Anchor anchor)
{
    switch (anchor) {
        case drawing::Anchor::Start: return DxfText::Align::Left;
        case drawing::Anchor::Middle: return DxfText::Align::Centre;
        case drawing::Anchor::End: return DxfText::Align::Right;
    }
    return DxfText::Align::Left;
}

}  // namespace

DxfDrawing dxfOf(const drawing::Drawing& drawing)
{
    DxfDrawing dxf;
    for (const drawing::Line& line : drawing.lines)
        dxf.lines.push_back({line.from_mm, line.to_mm, layerOf(line.layer)});
    for (const drawing::Arc& arc : drawing.arcs)
        dxf.arcs.push_back({arc.centre_mm, arc.radius_mm, arc.start_deg, arc.end_deg, layerOf(arc.layer)});
    for (const drawing::Label& label : drawing.labels)
        dxf.texts.push_back(
            {label.at_mm, label.height_mm, label.angle_deg, label.text, alignOf(label.anchor), layerOf(label.layer)});
    for (const drawing::Arrow& arrow : drawing.arrows)
        dxf.arrows.push_back({arrow.tip_mm, arrow.direction, arrow.length_mm, layerOf(arrow.layer)});
    return dxf;
}

}  // namespace lathelier::cad
