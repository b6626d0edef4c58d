#include "engine/cad/solidworks_macro.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;

/// "x, y, 0" in metres: z of the shaft along x, its radius along y.
std::string point(const Vector2d& zr_mm)
{
    const auto metres = [](double mm) { return fmt::format("{:.12f}", mm == 0 ? 0.0 : mm / 1000); };
    return metres(zr_mm.x()) + ", " + metres(zr_mm.y()) + ", 0#";
}

}  // namespace

std::string solidworksMacro(const Shaft& shaft)
{
    checkShaft(shaft);
    requireSolidOfRows(shaft);
    Contour closed = closedContour(shaft);
    if ((closed.back().to_mm - closed.front().from_mm).norm() > 1e-9)
        closed.push_back({closed.back().to_mm, closed.front().from_mm, 0});
    const double length = shaft.length_mm();
    std::string text =
        "' SolidWorks macro written by Lathelier: the drawn shaft as a revolved body. Metres and radians.\n"
        "' Not tested in SolidWorks: check the volume of the body against the shaft's.\n";
    text += fmt::format("' Volume {:.9g} mm3, length {:.9g} mm\n", volume_mm3(shaft), length);
    text +=
        "Option Explicit\n"
        "Sub main()\n"
        "    Dim swApp As Object, part As Object, sketch As Object, item As Object, ok As Boolean\n"
        "    Set swApp = Application.SldWorks\n"
        "    Set part = swApp.NewPart\n"
        "    ok = part.Extension.SelectByID2(\"Front Plane\", \"PLANE\", 0, 0, 0, False, 0, Nothing, 0)\n"
        "    Set sketch = part.SketchManager\n"
        "    sketch.InsertSketch True\n"
        "    sketch.AddToDB = True\n";
    text += fmt::format("    Set item = sketch.CreateCenterLine({}, {})\n", point({0, 0}), point({length, 0}));
    for (const ContourPiece& piece : closed) {
        if (!piece.isArc()) {
            text += fmt::format("    Set item = sketch.CreateLine({}, {})\n", point(piece.from_mm), point(piece.to_mm));
            continue;
        }
        // Direction 1 is anticlockwise; an arc that bulges to the left of its travel turns clockwise.
        text += fmt::format("    Set item = sketch.CreateArc({}, {}, {}, {})\n", point(piece.centre_mm()),
                            point(piece.from_mm), point(piece.to_mm), piece.arc_radius_mm > 0 ? -1 : 1);
    }
    // Diameters and lengths of the rows of the outside, driven by the sketch.
    text += "    sketch.AddToDB = False\n";
    for (const ContourPiece& piece : outerContour(shaft)) {
        if (piece.isArc() || piece.row == ContourPiece::none) continue;
        const Vector2d middle = (piece.from_mm + piece.to_mm) / 2;
        text += fmt::format(
            "    part.ClearSelection2 True\n"
            "    ok = part.Extension.SelectByID2(\"\", \"SKETCHSEGMENT\", {}, False, 0, Nothing, 0)\n"
            "    If ok Then Set item = part.AddDimension2({})\n",
            point(middle), point(middle + Vector2d(0, 10)));
    }
    text +=
        "    part.ClearSelection2 True\n"
        "    sketch.InsertSketch True\n"
        "    Set item = part.FeatureManager.FeatureRevolve2(True, True, False, False, False, False, 0, 0, "
        "6.2831853071796, 0, False, False, 0, 0, 0, 0, 0, True, True, True)\n"
        "    part.ViewZoomtofit2\n"
        "End Sub\n";
    return text;
}

}  // namespace lathelier::cad
