// Round values for the ticks of an axis.
#pragma once

#include <string>
#include <vector>

#include "engine/core/texts.h"
#include "engine/report/chart.h"

namespace lathelier::report {

struct Ticks {
    std::vector<double> values;  ///< tick values, ascending
    std::vector<double> minor;   ///< minor ticks, without labels
    int decimals = 0;            ///< enough to distinguish neighbours; -1: shortest representation of each
    double factor = 1;           ///< tick label = value × factor
};

/// Ticks at multiples of 1, 2 or 5 × 10^n inside [from, to], about `wanted` of them. from < to, both finite, wanted
/// >= 1.
Ticks niceTicks(double from, double to, int wanted);

/// Ticks of a logarithmic axis at 1, 2 and 5 × 10^n where there is space, else at powers of ten, with minor ticks
/// between; over less than half a decade as niceTicks(). 0 < from < to.
Ticks logTicks(double from, double to, int wanted);

/// According to the scale; for Scale::Whole at least 1 apart. With a `factor` (ShownUnit) the numbers are readable
/// after they are multiplied by it.
Ticks axisTicks(Axis::Scale scale, const Interval& range, int wanted, double factor = 1);

std::string tickLabel(double value, const Ticks& ticks, const Language& language);

}  // namespace lathelier::report
