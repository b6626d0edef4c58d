// Marks that no turned faces can stand for.
#pragma once

#include "engine/shaft/shaft.h"

namespace lathelier {

/// Is the row along such a mark another body than the part: an eccentric, a prism, teeth?
bool isOtherThanTurned(MarkKind kind);

/// For whoever makes a program of the rows. Error markNotTurned: the first such mark.
void requireTurned(const Shaft& shaft);

/// For whoever makes a solid or a contour of the rows alone: likewise, and no holes. Keyways and flats are left out
/// with a note.
void requireSolidOfRows(const Shaft& shaft);

}  // namespace lathelier
