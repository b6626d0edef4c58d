// Rows and bores from a closed meridian: the way back from engine/core/shaft_contour.h.
#pragma once

#include "engine/core/shaft.h"
#include "engine/core/shaft_contour.h"

namespace lathelier::cad {

/// The shaft of a closed meridian, clockwise in (z, r), pieces on the axis left out or not. Its free end is the least
/// z, from which the z of the shaft counts; the outside runs between the outermost points of both ends. Lines across
/// the axis become jumps between rows. What no shaft can be, a bore wider inside its end's face say, is for
/// checkShaft().
Shaft shaftOf(const Contour& closed);

}  // namespace lathelier::cad
