// Nominal sizes for the rows of one contour whose roles are known.
#pragma once

#include <vector>

#include "engine/features/nominal/row_chain.h"

namespace lathelier::features {

/// The patterns found in a contour.
struct Patterns {
    std::vector<UndercutRows> undercuts;
    std::vector<GrooveRows> grooves;
};

/// Suggestions for each row, in order. `thread_of` gives the mark of a row with role "thread"; nullptr: none.
std::vector<std::vector<Suggestion>> suggestionsFor(const RowChain& chain, const Patterns& patterns,
                                                    const std::vector<const ShaftMark*>& thread_of);

/// Is this chamfer or round too small to determine its form?
bool isEdgeBreak(const RowChain& chain, std::size_t i);

}  // namespace lathelier::features
