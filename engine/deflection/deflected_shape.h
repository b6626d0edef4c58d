// The deflected workpiece with the tool at one position.
#pragma once

#include <vector>

#include "engine/deflection/deflection.h"

namespace lathelier::deflection {

/// Displacement of the workpiece axis.
struct DeflectedShape {
    double tool_z_mm = 0;           ///< node nearest to the requested z
    cutting::CuttingForces forces;  ///< at that node; zero in air
    std::vector<double> z_mm;       ///< from the free end to the chuck face
    std::vector<double> x_um;       ///< toward the tool
    std::vector<double> y_um;       ///< along the cutting speed
};

/// During pass `pass` (an index into DeflectionResult::passes), with the tool at `z_mm` or at the end of the pass that
/// is nearer. Precondition: `pass` is in range. Cost: that of the passes up to it.
DeflectedShape deflectedShape(const WorkPlan& plan, const TurningSetup& setup, std::size_t pass, double z_mm);

}  // namespace lathelier::deflection
