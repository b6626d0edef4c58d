// Changes to the structure of a fitted model; sizes follow from the joint fit afterwards (model_fit.h).
//
// Rows are the elements of all runs in order. Where two lines would be left that are parallel, and so have no
// intersection, a plane is put between them.
#pragma once

#include <cstddef>

#include "engine/features/outline/outline.h"
#include "engine/features/refit/row_change.h"

namespace lathelier::features {

std::size_t countRows(const Model& model);

/// Does one change to the outline's model and gaps, starting values included; `zero_mm`: the free end in the frame of
/// the model. Errors: rowNotThere, rowNotChangeable.
void changeStructure(Outline& outline, const RowChange& change, double zero_mm);

}  // namespace lathelier::features
