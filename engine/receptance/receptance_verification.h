// Verification of shafts on machines: beams and coupling; of machines: spindle/spindle_verification.h.
#pragma once

#include "engine/core/verification.h"

namespace lathelier::receptance {

/// Natural frequencies of a rod and of a slender beam, free and clamped; receptances of the papers' shaft and static
/// bending of a clamped rod; two coupled halves equal to the whole, and a rod on springs; inverse coupling.
const VerifyPart& receptanceVerification();

VerifyKind verifyNaturalFrequencies();
VerifyKind verifyBeamReceptances();
VerifyKind verifyCoupling();
VerifyKind verifyCoupledRod();

/// The closed form against finite elements, rms over the lines.
VerifyKind verifyFiniteElements();

}  // namespace lathelier::receptance
