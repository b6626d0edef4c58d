// Descriptions of the parts of a recognition (rows, features, ends, gaps) for JSON, tables and CSV.
#pragma once

#include "engine/core/quantities.h"
#include "engine/features/recognition.h"

namespace lathelier::features {

const std::vector<QuantityOf<Suggestion>>& quantitiesOf(const Suggestion*);
const std::vector<QuantityOf<RecognizedRow>>& quantitiesOf(const RecognizedRow*);
const std::vector<QuantityOf<RecognizedFeature>>& quantitiesOf(const RecognizedFeature*);
const std::vector<QuantityOf<RecognizedEnd>>& quantitiesOf(const RecognizedEnd*);
const std::vector<QuantityOf<Gap>>& quantitiesOf(const Gap*);
const std::vector<QuantityOf<MergedJunction>>& quantitiesOf(const MergedJunction*);

const std::vector<QuantityOf<UnexplainedStructure>>& quantitiesOf(const UnexplainedStructure*);

const char* key(RowKind kind);        ///< "cylinder", "cone", "arc"
const char* key(StructureKind kind);  ///< "raised", "sunken", "no_points", "rough", "eccentric"

/// The result as `recognize --json` has it, but for `steps`, which are those of the published method only when it was
/// asked for.
Json toJson(const Recognition& result);

}  // namespace lathelier::features
