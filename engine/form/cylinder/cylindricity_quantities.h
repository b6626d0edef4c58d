// Description of the cylindricity results: keys, names, units and decimals for JSON and tables.
#pragma once

#include "engine/core/quantities.h"
#include "engine/form/cylinder/cylindricity.h"

namespace lathelier::form {

const std::vector<QuantityOf<FittedCylinder>>& quantitiesOf(const FittedCylinder*);
const std::vector<QuantityOf<CylindricityResult>>& quantitiesOf(const CylindricityResult*);

}  // namespace lathelier::form
