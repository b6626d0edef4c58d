// Operations for the residual material of the finishing tool: back turning, then grooving. Grooves are not labelled in
// the drawing; they are the intervals that a blade reaches and no profile tool does.
//
// Each operation covers one interval, is tested on a copy of the stock, and accepted or refused (work_stock.h).
#pragma once

#include "engine/cam/operation.h"
#include "engine/cam/work_frame.h"
#include "engine/cam/work_stock.h"

namespace lathelier::cam {

inline constexpr double leastGain_mm = 0.01;  ///< smaller improvements do not justify an operation

/// Along the curve of the opposite hand over an interval, from its end toward the chuck to the other; stock deeper than
/// the roughing depth is removed in levels first. None: the curve has no piece there.
std::optional<Operation> backTurning(const WorkFrame& frame, const JobTool& tool, const ToolReach& reach,
                                     const Unreached& rest, const WorkStock& stock);

/// Plunges every 0.7 w to 0.05 mm above the floor, then both walls downward to the floor. None: the curve has no piece
/// there.
std::optional<Operation> grooving(const WorkFrame& frame, const JobTool& blade, const ToolReach& reach,
                                  const Unreached& rest, const WorkStock& stock);

/// Radial depth of a groove below the surrounding stock; compared with Tool::reach_mm.
double depthOf(const Operation& grooving, const JobTool& blade, const WorkStock& stock);

/// The intervals of `rest` that the tool would reduce by at least leastGain_mm. Corners at the foot of a shoulder
/// rising toward the chuck are excluded.
std::vector<Unreached> improvableRests(const WorkFrame& frame, const std::vector<Unreached>& rest,
                                       const std::vector<ToolReach>& so_far, const ToolReach& tool);

}  // namespace lathelier::cam
