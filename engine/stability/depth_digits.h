// Decimals of a depth of cut: slender parts have limits of tenths of a micrometre, which three decimals show as zero.
#pragma once

#include <algorithm>
#include <cmath>

namespace lathelier::stability {

/// At least three decimals, and as many as show three digits of the value, up to nine.
inline int depthDecimals(double depth_mm)
{
    constexpr int usual = 3, digits = 3, most = 9;
    if (!(std::abs(depth_mm) > 0) || !std::isfinite(depth_mm)) return usual;
    const int leading = static_cast<int>(std::floor(std::log10(std::abs(depth_mm))));
    return std::clamp(digits - 1 - leading, usual, most);
}

/// Rounded to these decimals.
inline double roundedDepth(double depth_mm)
{
    const double unit = std::pow(10.0, depthDecimals(depth_mm));
    return std::round(unit * depth_mm) / unit;
}

}  // namespace lathelier::stability
