// Keys of the quantities of a plan for JSON and tables: `setups`, `rest`, `sections`, `check`.
#pragma once

#include "engine/cam/plan.h"
#include "engine/core/quantities.h"

namespace lathelier::cam {

const std::vector<QuantityOf<PlannedOperation>>& quantitiesOf(const PlannedOperation*);
const std::vector<QuantityOf<SetupPlan>>& quantitiesOf(const SetupPlan*);
const std::vector<QuantityOf<SectionSpeed>>& quantitiesOf(const SectionSpeed*);
const std::vector<QuantityOf<TurningPlan>>& quantitiesOf(const TurningPlan*);

}  // namespace lathelier::cam
