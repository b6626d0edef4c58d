// Verification of inverse coupling: a spindle found again from responses made with it.
#pragma once

#include "engine/core/verification.h"

namespace lathelier::receptance {

/// From responses without noise, relative.
VerifyKind verifyInverseCoupling(const Progress& progress);

/// Responses with 1 % noise, made by finite elements where the identification has the closed form, with one mistake of
/// a tap test in each set: a sign turned, two points swapped, a distance stated wrongly. What the named remedy leaves
/// against what sound tests leave, in percent of the responses.
VerifyKind verifySpindleMistakes(const Progress& progress);

}  // namespace lathelier::receptance
