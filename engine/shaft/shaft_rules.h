// Validity rules of a shaft; errors name the row that violates them.
#pragma once

#include "engine/core/error.h"
#include "engine/shaft/shaft.h"

namespace lathelier {

/// Errors, the first in the order of the rows: shaftRowWrong (a number that is not finite; a diameter below 0, or 0
/// inside; an arc's radius less than half its chord; a negative length that is no face undercut, which is a row that
/// runs back into a face after a hollow arc; no rows), boresStatedTwice, shaftBoresMeet, shaftCrosses. Rows count from
/// 1. Gives remarks: shaftRowShort, shaftRowsInLine, shaftWallThin (below 0.01 mm), markOutsideRow.
Notes checkShaft(const Shaft& shaft);

/// Of these rules those about stated bores: boresStatedTwice, shaftBoresMeet.
void checkBores(const Shaft& shaft);

}  // namespace lathelier
