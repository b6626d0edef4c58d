// Verification of the comparison of scans with synthetic parts of known pose and known deviations.
#pragma once

#include "engine/core/verification.h"

namespace lathelier::registration {

/// An angle (general part) as a mesh laid on itself from other poses; a stepped shaft (body of revolution) with a
/// collar that is larger or smaller by a known amount.
const VerifyPart& registrationVerification();

}  // namespace lathelier::registration
