// The bent work while the tool stands at one place.
#pragma once

#include <vector>

#include "engine/deflection/deflection.h"

namespace lathelier::deflection {

/// Motions of the axis of the work.
struct DeflectedShape {
    double tool_z_mm = 0;           ///< node nearest to what was asked
    cutting::CuttingForces forces;  ///< there; zero in air
    std::vector<double> z_mm;       ///< from the free end to the chuck face
    std::vector<double> x_um;       ///< toward the tool
    std::vector<double> y_um;       ///< along the cutting speed
};

/// During pass `pass` (an index into DeflectionResult::passes), with the tool at `z_mm` or at the end of the pass that
/// is nearer. Precondition: there is such a pass. Cost: the passes up to there.
DeflectedShape deflectedShape(const WorkPlan& plan, const TurningSetup& setup, std::size_t pass, double z_mm);

}  // namespace lathelier::deflection
