// Edges and hatching of a cross section, its centre at 0, in mm on paper.
#pragma once

#include "engine/drawing/drawing.h"
#include "engine/drawing/marks/cross_section.h"

namespace lathelier::drawing {

/// The direction of an angle in the section: 0 to the right, clockwise.
Eigen::Vector2d directionOf(double angle_deg);

/// Outline, bore, holes, teeth and hatching, without axes and dimensions.
Drawing sectionOutline(const CrossSection& section, double factor);

}  // namespace lathelier::drawing
