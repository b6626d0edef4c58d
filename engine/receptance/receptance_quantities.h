// Description of the results of shaftReceptance() and identifySpindle(): keys, names, units and decimals for JSON and
// tables.
#pragma once

#include "engine/core/quantities.h"
#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/eirc/spindle_check.h"
#include "engine/receptance/shaft/shaft_receptance.h"

namespace lathelier::receptance {

const std::vector<QuantityOf<ShaftReceptanceResult>>& quantitiesOf(const ShaftReceptanceResult*);
const std::vector<QuantityOf<SpindleIdentification>>& quantitiesOf(const SpindleIdentification*);
/// Columns of the table of responses, and the objects of `responses`.
const std::vector<QuantityOf<CheckedResponse>>& quantitiesOf(const CheckedResponse*);

}  // namespace lathelier::receptance
