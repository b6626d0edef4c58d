// The result of a recognition described for JSON, tables and CSV.
#pragma once

#include "engine/core/quantities.h"
#include "engine/features/paper_table.h"

namespace lathelier::features {

const std::vector<QuantityOf<Suggestion>>& quantitiesOf(const Suggestion*);
const std::vector<QuantityOf<RecognizedRow>>& quantitiesOf(const RecognizedRow*);
const std::vector<QuantityOf<RecognizedFeature>>& quantitiesOf(const RecognizedFeature*);
const std::vector<QuantityOf<RecognizedEnd>>& quantitiesOf(const RecognizedEnd*);
const std::vector<QuantityOf<Gap>>& quantitiesOf(const Gap*);
const std::vector<QuantityOf<MergedJunction>>& quantitiesOf(const MergedJunction*);
const std::vector<QuantityOf<PaperStep>>& quantitiesOf(const PaperStep*);
const std::vector<QuantityOf<Recognition>>& quantitiesOf(const Recognition*);

/// The largest diameter of the outside with its expanded uncertainty; none without rows.
struct LargestDiameter {
    double diameter_mm = 0;
    std::optional<double> uncertainty_um;  ///< k = 2
    std::size_t row = 0;                   ///< index into Recognition::segments
};
std::optional<LargestDiameter> largestDiameter(const Recognition& result);

/// What kinds, roles and ends are called; a role that is none of the known ones is said as it is.
Text kindName(RowKind kind);
Value roleName(const std::string& role);
Value endName(const std::string& closed_by);

}  // namespace lathelier::features
