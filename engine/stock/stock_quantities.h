// Results of the stock check described once, with the names of the command line: the JSON of `findings` and
// `stock_passes` is nestedJson(describedValues(result)).
#pragma once

#include "engine/core/quantities.h"
#include "engine/stock/stock_check.h"

namespace lathelier::stock {

const std::vector<QuantityOf<StockOutline>>& quantitiesOf(const StockOutline*);
const std::vector<QuantityOf<StockFinding>>& quantitiesOf(const StockFinding*);
const std::vector<QuantityOf<StockPass>>& quantitiesOf(const StockPass*);
const std::vector<QuantityOf<StockResult>>& quantitiesOf(const StockResult*);

}  // namespace lathelier::stock
