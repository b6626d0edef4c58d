// Where marks lie in the views of a shaft.
#pragma once

#include <optional>
#include <utility>

#include "engine/drawing/rows.h"
#include "engine/shaft/shaft.h"

namespace lathelier::drawing {

/// Angle about the axis that the viewer of the main view looks at: that of the first keyway, else of another mark whose
/// direction matters; an eccentric or a circle of holes alone is shown with its offset or a hole upward.
double viewedAngle_deg(const Shaft& shaft);

/// The mark that this angle is of; nullptr: none has one.
const ShaftMark* viewedMark(const Shaft& shaft);

/// Angle of the mark from there, in ]-180, 180]; 0 where it has none.
double turnOf_deg(const ShaftMark& mark, double viewed_deg);

/// The first mark of this kind that the middle of the row lies in; nullptr: none.
const ShaftMark* markOver(const Shaft& shaft, MarkKind kind, const ContourRow& row);

/// The longest stretch of a row that no hexagon, square or spline takes: where it is a cylinder, with a ⌀. Empty where
/// they leave less than 0.5 mm.
std::pair<double, double> roundStretch(const Shaft& shaft, const ContourRow& row);

/// The shaft with the ends of its measured marks at the shoulders and ends of the part that they reach within 0.5 mm:
/// there the row tells where they end.
Shaft withSettledMarks(const Shaft& shaft);

/// How far the row's own axis lies above that of the part in the main view; 0: it is no eccentric.
double offsetOf(const Shaft& shaft, const ContourRow& row);

/// Floor of a keyway from the axis, of a shaft of this radius; none: not known.
std::optional<double> floorOf(const ShaftMark& keyway, double radius_mm);

}  // namespace lathelier::drawing
