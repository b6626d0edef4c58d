// Decimals of a depth of cut: slender parts have limits of tenths of a micrometre, which three decimals show as zero.
#pragma once

#include <cmath>

#include "engine/core/significant_digits.h"

namespace lathelier::stability {

inline int depthDecimals(double depth_mm)
{
    return decimalsOfThreeDigits(depth_mm, 3);
}

/// Rounded to these decimals.
inline double roundedDepth(double depth_mm)
{
    const double unit = std::pow(10.0, depthDecimals(depth_mm));
    return std::round(unit * depth_mm) / unit;
}

}  // namespace lathelier::stability
