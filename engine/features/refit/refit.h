// Repeats the joint fit of a recognition with a structure changed by hand: rows deleted, merged, split, of another
// kind.
#pragma once

#include <vector>

#include "engine/features/recognition.h"
#include "engine/features/refit/row_change.h"

namespace lathelier::features {

/// `found` with `changes` made one after the other to the rows of its outside, all sizes refitted to the same walls
/// (one damped least squares, as recognize() does at its end), with their U; ends, roles, features, suggestions and the
/// shaft follow. What a deleted row covered is left out of the fit; the place of a cut is known to 0.1 mm (k = 2), the
/// precision of pointing. Bores, marks and the steps of the published method stay. Errors: rowNotThere,
/// rowNotChangeable, rowsDoNotMeet. Throws Cancelled. Cost: about a fifth of recognize(), for any number of points.
/// Precondition: recognize() gave `found`.
Recognition refit(const Recognition& found, const std::vector<RowChange>& changes, const Progress& progress = {});

}  // namespace lathelier::features
