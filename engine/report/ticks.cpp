#include "engine/report/ticks.h"

#include <algorithm>
#include <cmath>

namespace lathelier {
namespace {

constexpr double longestFixed = 1e7;  ///< longer numbers are written with an exponent
constexpr int mostDecimals = 7;

}  // namespace

Ticks niceTicks(double from, double to, int wanted)
{
    const double rough = (to - from) / wanted;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * (1 - 1e-9)) {
            step = factor * power;
            break;
        }
    Ticks ticks;
    ticks.decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const double first = std::ceil(from / step - 1e-9);
    const double last = std::floor(to / step + 1e-9);
    // Counted, not stepped until the end: a step may be too small to change a large number.
    const int count = static_cast<int>(std::clamp(last - first + 1, 0.0, 4.0 * wanted));
    for (int i = 0; i < count; ++i) ticks.values.push_back((first + i) * step);
    return ticks;
}

std::string tickLabel(double value, const Ticks& ticks, const Language& language)
{
    if (std::abs(value) >= longestFixed || ticks.decimals > mostDecimals) return text(Value(value), language);
    return fixed(value, ticks.decimals, language);
}

}  // namespace lathelier
