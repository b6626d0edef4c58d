// A SolidWorks macro (VBA, .bas) that builds the shaft: a sketch of the closed meridian on the Front Plane, revolved.
// Metres and radians, as its API wants them. Never run by its makers: the macro says so in its head.
#pragma once

#include <string>

#include "engine/core/shaft.h"

namespace lathelier::cad {

/// Errors: those of checkShaft().
std::string solidworksMacro(const Shaft& shaft);

}  // namespace lathelier::cad
