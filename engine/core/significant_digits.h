// Decimals that show the digits of a small value.
#pragma once

#include <algorithm>
#include <cmath>

namespace lathelier {

/// At least `least` decimals, and as many as show three digits of the value, up to nine.
inline int decimalsOfThreeDigits(double value, int least)
{
    constexpr int digits = 3, most = 9;
    if (!(std::abs(value) > 0) || !std::isfinite(value)) return least;
    const int needed = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
    return std::clamp(needed, least, std::max(least, most));
}

}  // namespace lathelier
