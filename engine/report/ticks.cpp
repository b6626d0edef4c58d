#include "engine/report/ticks.h"

#include <algorithm>
#include <cmath>

namespace lathelier::report {
namespace {

constexpr double longestFixed = 1e7;  ///< larger numbers are written with an exponent
constexpr int mostDecimals = 7;

}  // namespace

Ticks niceTicks(double from, double to, int wanted)
{
    const double rough = (to - from) / wanted;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10 * power;
    int parts = 5;  ///< subdivisions of a step, so that minor ticks have round values
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * (1 - 1e-9)) {
            step = factor * power;
            parts = factor == 2.0 ? 4 : 5;
            break;
        }
    Ticks ticks;
    ticks.decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const double first = std::ceil(from / step - 1e-9);
    const double last = std::floor(to / step + 1e-9);
    // By index and not by accumulation: a step may be below the resolution of a large number.
    const int count = static_cast<int>(std::clamp(last - first + 1, 0.0, 4.0 * wanted));
    for (int i = 0; i < count; ++i) ticks.values.push_back((first + i) * step);
    for (int i = -1; i < count; ++i)
        for (int part = 1; part < parts; ++part) {
            const double value = (first + i + static_cast<double>(part) / parts) * step;
            if (value >= from && value <= to) ticks.minor.push_back(value);
        }
    return ticks;
}

Ticks logTicks(double from, double to, int wanted)
{
    const double decades = std::log10(to / from);
    if (decades < 0.5) return niceTicks(from, to, wanted);
    const int first = static_cast<int>(std::floor(std::log10(from)));
    const int last = static_cast<int>(std::floor(std::log10(to) + 1e-9));
    const bool between = 3 * decades <= wanted + 1 || decades < 1.5;
    const int every = std::max(1, static_cast<int>(std::ceil(decades / wanted)));
    Ticks ticks;
    ticks.decimals = -1;
    for (int power = first; power <= last; ++power)
        for (int digit = 1; digit < 10; ++digit) {
            const double value = digit * std::pow(10.0, power);
            if (value < from * (1 - 1e-9) || value > to * (1 + 1e-9)) continue;
            if (digit == 1 ? power % every == 0 : between && (digit == 2 || digit == 5))
                ticks.values.push_back(value);
            else if (every == 1 || digit == 1)
                ticks.minor.push_back(value);
        }
    return ticks;
}

Ticks axisTicks(Axis::Scale scale, const Interval& range, int wanted, double factor)
{
    if (factor != 1) {
        Ticks ticks = axisTicks(scale, {range.from * factor, range.to * factor}, wanted);
        for (std::vector<double>* places : {&ticks.values, &ticks.minor})
            for (double& place : *places) place /= factor;
        ticks.factor = factor;
        return ticks;
    }
    if (scale == Axis::Scale::Whole && range.to - range.from < wanted) {
        Ticks ticks = niceTicks(range.from, range.to, std::max(1, static_cast<int>(range.to - range.from)));
        ticks.minor.clear();
        return ticks;
    }
    return scale == Axis::Scale::Logarithmic && range.from > 0 ? logTicks(range.from, range.to, wanted)
                                                               : niceTicks(range.from, range.to, wanted);
}

std::string tickLabel(double value, const Ticks& ticks, const Language& language)
{
    const double number = value * ticks.factor;
    if (std::abs(number) >= longestFixed || ticks.decimals < 0 || ticks.decimals > mostDecimals)
        return text(Value(number), language);
    return fixed(number, ticks.decimals, language);
}

}  // namespace lathelier::report
