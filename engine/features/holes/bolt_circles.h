// Equal holes at equal angles on a circle about the axis, in the faces of a part.
#pragma once

#include <vector>

#include "engine/features/structure/face_map.h"
#include "engine/shaft/shaft.h"

namespace lathelier::features {

/// Marks of kind BoltCircle in order of z, in the frame of the outline, of 3 to 12 holes whose rims prove equal
/// circles. `angle_deg` is the smallest of the angles of its holes. A through one is in two faces: z of both; of others
/// both z are that of the face, and `through` is 0 where another face is seen over the whole circle without holes.
/// Throws Cancelled.
std::vector<ShaftMark> boltCircles(const std::vector<SeenFace>& faces, const Progress& progress = {});

}  // namespace lathelier::features
