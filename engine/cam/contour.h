// The drawing as a height function x = h(u): u from the free end toward the chuck, x the radius; walls are jumps.
// Lines and arcs are those of core/shaft_contour.h, walls between rows are pieces of their own.
#pragma once

#include "engine/shaft/shaft_contour.h"

namespace lathelier::cam {

/// Pieces run from smaller to larger u; a wall stays at one u. Points are (u, x) in mm.
struct HeightContour {
    Contour pieces;        ///< connected, from the free end to the other
    double length_mm = 0;  ///< of the part: where the drawing ends
};

/// Outside contour of a part. Precondition: checkPart() holds.
HeightContour heightContour(const Shaft& part);

/// With a cylinder of the last diameter behind its end, for `by_mm` more; the length of the part stays.
HeightContour extendedBy(HeightContour contour, double by_mm);

/// Seen from the other end: u becomes end - u, where `end` is the last u of the pieces.
HeightContour mirrored(const HeightContour& contour);

/// Slope of the tangent dx/du at the start and the end of a piece; ± infinity at a wall.
double startSlope(const ContourPiece& piece);
double endSlope(const ContourPiece& piece);

/// Smallest radius of the drawing on its way between two places.
double lowestRadius_mm(const HeightContour& contour, double from_mm, double to_mm);

}  // namespace lathelier::cam
