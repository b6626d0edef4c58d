// Keys of the quantities of the check for JSON and tables: `check` and `rest`.
#pragma once

#include "engine/cam/check/turning_check.h"
#include "engine/core/quantities.h"

namespace lathelier::cam {

const std::vector<QuantityOf<CheckFinding>>& quantitiesOf(const CheckFinding*);
const std::vector<QuantityOf<RestInterval>>& quantitiesOf(const RestInterval*);
const std::vector<QuantityOf<CheckResult>>& quantitiesOf(const CheckResult*);

}  // namespace lathelier::cam
