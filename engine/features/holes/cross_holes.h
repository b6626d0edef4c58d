// Round holes across the axis in the walls of the outside.
#pragma once

#include <vector>

#include "engine/features/marks/wall_rays.h"
#include "engine/features/structure/structure.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// Marks of kind CrossHole in order of z, in the frame of the outline: each a rim that proves a circle in the section
/// of a hole whose axis meets that of the part. Two equal rims opposite each other are one through hole; its
/// `angle_deg` is the smaller one. A floor that is seen gives the depth: to the full diameter, without the point of a
/// drill. `scan`: of the same outline. Throws Cancelled.
std::vector<ShaftMark> crossHoles(const WallScan& scan, const ResidualMap& map, const SurfaceTable& surface,
                                  double form_mm, const Progress& progress = {});

/// The marks with the holes in order of z: a floor named a keyway that is as short as its hole is the hole's, and a
/// hole in a longer one is a piece of the keyway.
std::vector<ShaftMark> withHoles(std::vector<ShaftMark> marks, std::vector<ShaftMark> holes);

}  // namespace lathelier::features
