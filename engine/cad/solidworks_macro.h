// A SolidWorks macro (VBA, .bas) that builds the shaft: a sketch of the closed meridian on the Front Plane, revolved.
// Units of its API: metres and radians. Not tested with SolidWorks, which its head states.
#pragma once

#include <string>

#include "engine/shaft/shaft.h"

namespace lathelier::cad {

/// Errors: those of checkShaft(); markNotTurned.
std::string solidworksMacro(const Shaft& shaft);

}  // namespace lathelier::cad
