// Where the speeds of sections stand among the moves of the finish.
//
// A new speed does not act at once: with N₁ and N₂ in 1/min, an acceleration α in 1/min/s and a feed f in mm/rev the
// tool travels L = f (N₁ + N₂)/120 |N₂ - N₁|/α meanwhile. The word stands where the cylinder before ends, if faces,
// chamfers and fillets up to the next one are as long as L; what is missing is taken from the end of the cylinder
// before, unless the drawing states its limits or its roughness: then the tool lifts off where nothing stands above it,
// and comes back to the same place at the new speed.
#pragma once

#include <vector>

#include "engine/cam/operation.h"
#include "engine/cam/section_speeds.h"

namespace lathelier::cam {

inline constexpr double spindleRamp_rpm_s = 1000;  ///< α, assumed

/// Lays the sections' speeds into the finish of this part: constant cutting speed up to the first cylinder and on
/// cones, a fixed one on cylinders; where the job states the speeds, those throughout.
void setFinishSpeeds(Operation& finish, const std::vector<SectionSpeed>& sections, const Shaft& part);

}  // namespace lathelier::cam
