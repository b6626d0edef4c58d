// A hexagon or a square whose corners a circle may cut.
#pragma once

#include <optional>

#include "engine/features/stretches/section_shape.h"

namespace lathelier::features {

/// Regular polygons of four and six faces. The direction of the faces is searched, then direction, distance and centre
/// are fitted to the points on the faces. None unless nearly all points lie on faces and on one circle over the
/// corners, and every face is seen. `mark.uncertainty_mm`: of the size across flats, from the scatter of the faces.
std::optional<FoundShape> prismOf(const StretchPoints& points);

}  // namespace lathelier::features
