// Descriptions of the single numbers of a recognition for tables, and names of its rows.
#pragma once

#include "engine/features/report/recognized_rows.h"

namespace lathelier::features {

/// For tables; JSON is toJson() (recognized_rows.h).
const std::vector<QuantityOf<Recognition>>& quantitiesOf(const Recognition*);

/// The largest diameter of the outside with its expanded uncertainty; none without rows.
struct LargestDiameter {
    double diameter_mm = 0;
    std::optional<double> uncertainty_um;  ///< k = 2
    std::size_t row = 0;                   ///< index into Recognition::segments
};
std::optional<LargestDiameter> largestDiameter(const Recognition& result);

/// Names of kinds, roles and ends; an unknown role is shown as it is.
Text kindName(RowKind kind);
Text structureName(StructureKind kind);
Value roleName(const std::string& role);
Value endName(const std::string& closed_by);

}  // namespace lathelier::features
