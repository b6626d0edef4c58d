// The worked example that everything in this room is checked by: case A of G. Grossi et al., "A digital solution for
// slender workpiece turning: the DRITTO project", a bar of 34 mm turned to 28 mm between chuck and tailstock.
#pragma once

#include "engine/core/shaft.h"
#include "engine/deflection/setup.h"

namespace lathelier::deflection {

/// Its tables 1 and 2; without the path of a stock.
TurningSetup caseASetup();

Shaft caseAStock();

}  // namespace lathelier::deflection
