// Results of trajectories as JSON, as scripts know them (COMMAND_LINE.md).
#pragma once

#include "engine/core/json.h"
#include "engine/spindle/trajectory.h"

namespace lathelier {

/// `sections`, `longitudinal` (null without known z), `workpiece_diameter_mm`, `cutting`, `verdict`…
Json toJson(const TrajectoryResult& result);

}  // namespace lathelier
