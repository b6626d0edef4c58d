// What can be verified of deflection: the force table and case A of the DRITTO paper, closed forms of beams.
#pragma once

#include "engine/core/verification.h"

namespace lathelier::deflection {

/// Forces at 3 and 1 mm; error at the printed places of case A; cantilever and beam on two supports.
const VerifyPart& deflectionVerification();

VerifyKind verifyCuttingForces();
VerifyKind verifyCaseA();
VerifyKind verifyBeams();

}  // namespace lathelier::deflection
