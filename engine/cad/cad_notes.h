// Features of a shaft that CAD files omit or represent differently.
#pragma once

#include "engine/core/error.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// Notes marksLeftOut and arcBeyondAxis, for whoever writes a CAD file of this shaft.
Notes cadNotes(const Shaft& shaft);

/// Error markNotMade where a mark is not made of turned faces (hexagon, square, spline, eccentric, hole): CAD files are
/// made of the rows alone, and would be another part. Keyways and flats are left out, with a note.
void requireTurned(const Shaft& shaft);

}  // namespace lathelier::cad
