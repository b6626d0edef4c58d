// The view of a shaft: edges, axis, hatching, thread roots, knurls and marks, in mm on paper from the axis at the free
// end.
#pragma once

#include "engine/drawing/drawing.h"
#include "engine/drawing/features.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::drawing {

/// Edges of the view without its axis; the upper half is cut where the shaft has bores. `shaft` with its bores stated.
Drawing viewOf(const Shaft& shaft, double factor);

using Polygon = std::vector<Eigen::Vector2d>;

/// Parallel lines at 45° inside closed polygons (even-odd), `spacing_mm` apart.
std::vector<Line> hatch(const std::vector<Polygon>& polygons, double spacing_mm);

/// The corners of closed pieces, arcs as steps of at most 2°, multiplied by `factor`.
Polygon polygonOf(const Contour& contour, double factor);

}  // namespace lathelier::drawing
