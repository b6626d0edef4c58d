// Roundness of points without noise.
#pragma once

#include "engine/form/roundness/roundness.h"

namespace lathelier::form {

/// A short wave of the form is point-to-point noise to the estimate; the tests of form state their own.
inline RoundnessParameters exact()
{
    RoundnessParameters parameters;
    parameters.probe_uncertainty_um = 0;
    return parameters;
}

}  // namespace lathelier::form
