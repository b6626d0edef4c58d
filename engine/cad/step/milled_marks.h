// Flats, keyways, slots and splines of a turned part, from groups of its faces that are connected by edges.
//
//   flat      planes along the axis that face away from it, with walls across the axis
//   keyway    a floor along the axis between two facing planes; ends round, straight or open; or a floor that is a
//             cylinder across the axis (a Woodruff key's, a disc cutter's run-out)
//   slot      two facing planes along the axis with a floor across it (a slot across an end), or none (through the
//   part) spline    four or more equal grooves, equally spaced, whose root is a cylinder about the axis
// Small rounds (cylinders, tori, spheres below a fifth of the group's area) do not matter.
#pragma once

#include <vector>

#include "engine/cad/step/hole_marks.h"

namespace lathelier::cad {

/// `named`: faces that are part of other marks. Flats of equal distance and length that form a hexagon or a square are
/// one mark.
NamedCuts milledOf(const std::vector<FaceShape>& faces, std::vector<bool> named, const Shaft& turned);

}  // namespace lathelier::cad
