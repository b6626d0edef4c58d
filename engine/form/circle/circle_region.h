// Feasible region for the centre of the maximum inscribed circle.
#pragma once

#include <vector>

#include "engine/form/circle/circle_points.h"
#include "engine/form/linear_minimax.h"

namespace lathelier::form {

/// The convex hull of the points and of `centre` (the least-squares circle's: not inside the hull for an arc of less
/// than half a turn) as half planes. Where the points closely surround `centre`, a polygon through a subset replaces
/// the hull: a centre between the two is nearer to a point than the optimal radius. Without this region the inscribed
/// circle of an arc would be unbounded on its open side.
std::vector<HalfPlane> inscribedRegion(const CirclePoints& points, const Eigen::Vector2d& centre,
                                       const std::array<CirclePoints::Sector, CirclePoints::sectorCount>& sectors);

}  // namespace lathelier::form
