// Description of the trajectory results: keys, names, units and decimals for JSON, tables and CSV.
#pragma once

#include "engine/core/quantities.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

const std::vector<QuantityOf<ErrorMotion>>& quantitiesOf(const ErrorMotion*);
const std::vector<QuantityOf<TrajectorySection>>& quantitiesOf(const TrajectorySection*);
const std::vector<QuantityOf<LongitudinalSection>>& quantitiesOf(const LongitudinalSection*);

/// `sections`, `longitudinal` (null without known z), `workpiece_diameter_mm`, `cutting`, `verdict`…, in the form
/// documented for scripts.
Json toJson(const TrajectoryResult& result);

}  // namespace lathelier::trajectory
