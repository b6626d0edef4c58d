// Features of a shaft that CAD files omit or represent differently.
#pragma once

#include "engine/core/error.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// Notes marksLeftOut and arcBeyondAxis, for whoever writes a CAD file of this shaft.
Notes cadNotes(const Shaft& shaft);

/// Error markNotMade where a stretch is no body of revolution about the common axis (hexagon, square, spline,
/// eccentric): a solid of its plain body would be another part. What is milled or drilled into a body is left out.
void requireTurned(const Shaft& shaft);

}  // namespace lathelier::cad
