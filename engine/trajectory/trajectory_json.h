// Results of trajectories as JSON, as scripts know them.
#pragma once

#include "engine/core/json.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

/// `sections`, `longitudinal` (null without known z), `workpiece_diameter_mm`, `cutting`, `verdict`…
Json toJson(const TrajectoryResult& result);

}  // namespace lathelier::trajectory
