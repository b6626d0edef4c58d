// Passes of the finishing tool where it gets far below what roughing leaves: behind a fall that the roughing insert's
// back edge cannot follow, a single pass would cut as deep as the rest is.
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
