// Where the centre of the maximum inscribed circle may lie.
#pragma once

#include <vector>

#include "engine/form/circle/circle_points.h"
#include "engine/form/linear_minimax.h"

namespace lathelier::form {

/// The convex hull of the points and of `centre` (the least-squares circle's: an arc of less than half a turn does not
/// hold it) as half planes. Where the points surround `centre` closely, a polygon of some of them stands for the hull:
/// what lies between the two is nearer to a point than the circle may be. A circle whose centre could be outside would
/// grow into the open side of an arc without limit.
std::vector<HalfPlane> inscribedRegion(const CirclePoints& points, const Eigen::Vector2d& centre,
                                       const std::array<CirclePoints::Sector, CirclePoints::sectorCount>& sectors);

}  // namespace lathelier::form
