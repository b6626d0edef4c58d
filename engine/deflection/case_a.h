// Reference example of this room: case A of G. Grossi et al., "A digital solution for slender workpiece turning: the
// DRITTO project", a bar of 34 mm turned to 28 mm between chuck and tailstock.
#pragma once

#include "engine/deflection/setup.h"
#include "engine/shaft/shaft.h"

namespace lathelier::deflection {

/// Set-up of its tables 1 and 2, without stock file.
TurningSetup caseASetup();

Shaft caseAStock();

}  // namespace lathelier::deflection
