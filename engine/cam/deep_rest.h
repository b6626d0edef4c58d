// Additional passes of the finishing tool where the material left by roughing exceeds its depth of cut: behind a
// falling flank steeper than the back angle of the roughing insert.
#pragma once

#include "engine/cam/operation.h"
#include "engine/cam/work_frame.h"
#include "engine/cam/work_stock.h"

namespace lathelier::cam {

inline constexpr double deepFinish_mm = 1.5;  ///< deepest cut of a finishing tool, or the depth of roughing if less

/// Along the finishing tool's curves with allowances that fall in equal steps, over the intervals where roughing leaves
/// more than one step. `stock`: after the semi-finish. None: it leaves no more than one step anywhere.
std::optional<Operation> deepPasses(const WorkFrame& frame, const JobTool& rough, const JobTool& finish,
                                    const WorkStock& stock);

}  // namespace lathelier::cam
