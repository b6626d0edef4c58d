// Operations for what the finishing tool has left: the opposite hand, then blades. A groove needs no label in the
// drawing: it is what no profile tool reaches and a blade does.
//
// An operation is laid over an interval of rest, tried on a copy of the stock, and kept or refused (work_stock.h).
#pragma once

#include "engine/cam/operation.h"
#include "engine/cam/work_frame.h"
#include "engine/cam/work_stock.h"

namespace lathelier::cam {

inline constexpr double leastGain_mm = 0.01;  ///< less than this is not worth a tool

/// Along the curve of the opposite hand over an interval, from its end toward the chuck to the other; what is deeper
/// than the depth of roughing in levels first. None: the curve holds nothing there.
std::optional<Operation> backTurning(const WorkFrame& frame, const JobTool& tool, const ToolReach& reach,
                                     const Unreached& rest, const WorkStock& stock);

/// Plunges every 0.7 w to 0.05 mm above the floor, then both walls downward to the floor. None: nothing there.
std::optional<Operation> grooving(const WorkFrame& frame, const JobTool& blade, const ToolReach& reach,
                                  const Unreached& rest, const WorkStock& stock);

/// How deep a blade has to reach below the stock around it for a groove; compared with JobTool::max_depth_mm.
double depthOf(const Operation& grooving, const JobTool& blade, const WorkStock& stock);

/// The intervals of `rest` where the tool would leave less by leastGain_mm. A corner that a nose rounds at a drawn
/// shoulder stays: a blade is not brought there for it.
std::vector<Unreached> worthwhile(const WorkFrame& frame, const std::vector<Unreached>& rest,
                                  const std::vector<ToolReach>& so_far, const ToolReach& tool);

}  // namespace lathelier::cam
