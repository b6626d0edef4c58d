// Positions of the speed words of sections in the moves of finishing.
//
// The spindle needs time to accelerate: with N₁ and N₂ in 1/min, an acceleration α in 1/min/s and a feed f in mm/rev
// the tool travels L = f (N₁ + N₂)/120 |N₂ - N₁|/α meanwhile. The speed word is placed at the end of the previous
// cylinder if faces, chamfers and fillets up to the next one are at least L long. Otherwise it is placed earlier on the
// previous cylinder, unless the drawing states limits or roughness for it: then the tool retracts where it is free, and
// returns to the same point at the new speed.
#pragma once

#include <vector>

#include "engine/cam/operation.h"
#include "engine/cam/section_speeds.h"

namespace lathelier::cam {

inline constexpr double spindleRamp_rpm_s = 1000;  ///< α, assumed

/// Inserts the speeds of the sections into the finishing of this part: constant cutting speed up to the first cylinder
/// and on cones, a fixed one on cylinders; where the job states the speeds, those throughout.
void setFinishSpeeds(Operation& finish, const std::vector<SectionSpeed>& sections, const Shaft& part);

}  // namespace lathelier::cam
