// Usual causes of the strongest harmonics of a profile on a lathe.
#pragma once

#include <vector>

#include "engine/form/roundness/roundness.h"

namespace lathelier::form {

/// The strongest harmonics with at least a tenth of the form's variance and significant against the point noise, at
/// most four, the strongest first; after them the eccentricity when it is larger than the form.
std::vector<RoundnessHint> roundnessHints(const RoundnessResult& result);

/// Usual cause of `upr` undulations per revolution.
Text usualCause(int upr);

/// Short name of the cause, beside a number: "2 oval". Empty where there is none.
Text shortCause(int upr);

}  // namespace lathelier::form
