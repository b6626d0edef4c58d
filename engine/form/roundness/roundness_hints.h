// What the strongest waves of a profile usually mean on a lathe.
#pragma once

#include <vector>

#include "engine/form/roundness/roundness.h"

namespace lathelier::form {

/// The strongest harmonics that hold at least a tenth of the form's variance and stand out of the points' noise, at
/// most four, the strongest first; after them the eccentricity when it is larger than the form.
std::vector<RoundnessHint> roundnessHints(const RoundnessResult& result);

/// What waves of `upr` undulations per revolution usually come from.
Text usualCause(int upr);

/// The same in a word, beside a number: "2 oval". Empty where there is none.
Text shortCause(int upr);

}  // namespace lathelier::form
