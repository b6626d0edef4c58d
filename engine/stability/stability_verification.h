// Verification of lobes, recommended speeds and simulation.
#pragma once

#include "engine/core/verification.h"

namespace lathelier::stability {

/// Limits of the worked example by the exact and the published relation; the characteristic equation at the lobes' own
/// lines, with and without process damping; the speeds of both source papers; growth of the simulated cut against the
/// rightmost root.
const VerifyPart& stabilityVerification();

VerifyKind verifyLobeLimits();
VerifyKind verifyCharacteristicEquation();
VerifyKind verifyDampedLobes();
VerifyKind verifyRecommendedSpeeds();
VerifyKind verifyGrowth(const Progress& progress);

/// At random machines the depth where the rightmost root neither grows nor decays, against the limit.
VerifyKind verifyDelayEquation(const Progress& progress);

/// The least real part of impact tests whose lowest lines are noise, against that of the structure.
VerifyKind verifyNoisyLimits();

}  // namespace lathelier::stability
