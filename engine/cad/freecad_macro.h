// A FreeCAD macro (.FCMacro, Python) that builds the shaft as a parametric body: a fully constrained sketch of the
// closed meridian, revolved, its sizes bound to a spreadsheet of diameters, lengths and radii.
//
// Each radius is given once for all vertices that share it, each z follows from one chain of lengths: no constraint is
// redundant, as redundant ones stop the recompute of FreeCAD. Aliases: Dia_1 (start of row 1), Dia_e4 (end of row 4),
// Len_2, Rad_7; of bores Dia_b1_1 and so on. Needs FreeCAD 0.20 or later.
#pragma once

#include <string>

#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// Errors: those of checkShaft(); markNotTurned.
std::string freecadMacro(const Shaft& shaft);

}  // namespace lathelier::cad
