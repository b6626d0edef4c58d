// Rows and bores from a closed meridian: the inverse of engine/shaft/shaft_contour.h.
#pragma once

#include "engine/shaft/shaft.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {

/// The shaft of a closed meridian, clockwise in (z, r), with or without pieces on the axis. Its free end is the least
/// z, from which the z of the shaft counts; the outside runs between the outermost points of both ends. Lines across
/// the axis become jumps between rows. Impossible shafts are not detected here, but by checkShaft().
Shaft shaftOf(const Contour& closed);

}  // namespace lathelier::cad
