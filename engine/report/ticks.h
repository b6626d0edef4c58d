// Readable places for the ticks of an axis.
#pragma once

#include <string>
#include <vector>

#include "engine/core/texts.h"

namespace lathelier {

/// Ticks at multiples of 1, 2 or 5 × 10^n inside [from, to], about `wanted` of them.
struct Ticks {
    std::vector<double> values;
    int decimals = 0;  ///< enough to tell neighbours apart
};

/// from < to, both finite, wanted >= 1.
Ticks niceTicks(double from, double to, int wanted);

std::string tickLabel(double value, const Ticks& ticks, const Language& language);

}  // namespace lathelier
