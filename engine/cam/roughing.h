// Roughing on equal levels, and the semi-finish that leaves a constant allowance.
//
// n = ceil((R - x_min)/a_p) equal steps from the bar to the lowest place of f_δ; levels 1 … n - 1 are longitudinal
// passes toward the chuck over the intervals where f_δ lies below the level, in closed form; the semi-finish along f_δ
// removes the last step, at most a_p deep. The first interval is entered from the front. A later one is a pocket: the
// tool comes down above the stock as it is, feeds down along f_δ from the level before, so never more steeply than its
// back angle, and follows the level.
#pragma once

#include "engine/cam/operation.h"
#include "engine/cam/work_frame.h"
#include "engine/cam/work_stock.h"

namespace lathelier::cam {

/// Removes the passes from `stock`. None: one step is enough; the semi-finish removes it.
std::optional<Operation> roughing(const WorkFrame& frame, const JobTool& tool, WorkStock& stock);

/// From the face's foot along f_δ to the end, then outward.
Operation semiFinishing(const WorkFrame& frame, const JobTool& tool);

/// Along f from the axis up the face to the end, then outward; with a tailstock from 1 mm outside its centre hole.
Operation finishing(const WorkFrame& frame, const JobTool& tool);

}  // namespace lathelier::cam
