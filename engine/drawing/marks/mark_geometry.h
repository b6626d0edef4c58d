// Where marks lie in the views of a shaft.
#pragma once

#include <optional>

#include "engine/drawing/rows.h"
#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

/// Angle about the axis that the viewer of the main view looks at: that of the first keyway, else of another mark whose
/// direction matters; an eccentric alone is shown with its offset upward.
double viewedAngle_deg(const Shaft& shaft);

/// Angle of the mark from there, in ]-180, 180]; 0 where it has none.
double turnOf_deg(const ShaftMark& mark, double viewed_deg);

/// The first mark of this kind that the middle of the row lies in; nullptr: none.
const ShaftMark* markOver(const Shaft& shaft, MarkKind kind, const ContourRow& row);

/// Hexagon, square, spline: the row is no cylinder and its ⌀ is not dimensioned.
bool hasShapeOfItsOwn(const Shaft& shaft, const ContourRow& row);

/// How far the row's own axis lies above that of the part in the main view; 0: it is no eccentric.
double offsetOf(const Shaft& shaft, const ContourRow& row);

/// Floor of a keyway from the axis, of a shaft of this radius; none: not known.
std::optional<double> floorOf(const ShaftMark& keyway, double radius_mm);

}  // namespace lathelier::drawing
