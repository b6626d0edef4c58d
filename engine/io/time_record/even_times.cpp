#include "engine/io/time_record/even_times.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/statistics.h"

namespace lathelier::io {
namespace {

constexpr double unevenShare = 0.01;
constexpr double coarseShare = 0.25;  ///< of a step: times rounded to more say nothing about single steps
constexpr std::size_t samplesPerCheck = 1 << 16;

/// The power of ten that the times are written in, found from the first of them; 0: none.
double writtenResolution(std::span<const double> times)
{
    constexpr int mostDigits = 12;
    constexpr std::size_t judged = 1000;
    double resolution = 1;
    for (int digits = 0; digits < mostDigits; ++digits, resolution /= 10) {
        const bool fits =
            std::all_of(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(std::min(times.size(), judged)),
                        [resolution](double time) {
                            const double steps = time / resolution;
                            return std::abs(steps - std::round(steps)) < 1e-4 + std::abs(steps) * 1e-14;
                        });
        if (fits) return resolution;
    }
    return 0;
}

/// The median of at most a million of the steps.
double usualStep(std::span<const double> times)
{
    constexpr std::size_t most = 1000000;
    const std::size_t stride = (times.size() - 1) / most + 1;
    std::vector<double> some;
    for (std::size_t i = 1; i < times.size(); i += stride) some.push_back(times[i] - times[i - 1]);
    return upperMedianInPlace(some);
}

}  // namespace

EvenTimes judgeTimes(std::span<const double> times, const Progress& progress)
{
    EvenTimes found;
    if (times.size() < 2) return found;
    found.step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    const double usual = usualStep(times);
    const double resolution = writtenResolution(times);
    // Where the step is a multiple of what is written, no rounding explains another one.
    const bool is_exact =
        std::abs(times.back() - times.front() - usual * static_cast<double>(times.size() - 1)) <= 1.01 * resolution;
    const bool is_coarse = !is_exact && resolution > coarseShare * std::max(found.step, usual);
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (i % samplesPerCheck == 0) progress.check();
        const double step = times[i] - times[i - 1];
        const double single = 2 * std::numeric_limits<float>::epsilon() * std::abs(times[i]);
        const double rounding = std::min(std::max(is_exact ? 0 : resolution, single), coarseShare * std::abs(usual));
        const double even = times.front() + found.step * static_cast<double>(i);
        const bool fits = is_coarse ? step >= 0 && std::abs(times[i] - even) <= 1.01 * resolution
                                    : step > 0 && std::abs(step - usual) <= unevenShare * usual + rounding;
        if (fits && std::isfinite(step)) continue;
        found.uneven = UnevenStep{i, step, is_coarse ? found.step : usual};
        return found;
    }
    if (!(found.step > 0)) found.uneven = UnevenStep{times.size() - 1, found.step, usual};
    return found;
}

}  // namespace lathelier::io
