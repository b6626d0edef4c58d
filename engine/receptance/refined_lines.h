// Lines of a response that are dense where it curves: a limit depends on the least real part, which a slender bar on a
// stiff chuck has within a fraction of a hertz.
#pragma once

#include <functional>
#include <vector>

#include "engine/core/frf.h"

namespace lathelier::receptance {

/// Values of the response at these frequencies.
using ValuesAt = std::function<std::vector<std::complex<double>>(const std::vector<double>& frequency_hz)>;

/// Halves the intervals between lines until the value at the middle of each lies within 0.1 % of |G| on the straight
/// line between its ends: the least real part is then within 0.2 % of its value. Lines that are not needed are not
/// added. At most 20 halvings and 200 000 lines.
void refineLines(Frf& frf, const ValuesAt& values_at);

}  // namespace lathelier::receptance
