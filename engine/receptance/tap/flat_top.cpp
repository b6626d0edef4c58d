#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/receptance/tap/tap_hits.h"

namespace lathelier::receptance {
namespace {

constexpr std::size_t leastRun = 3;  ///< samples that stand level
constexpr double farShare = 0.5;     ///< of the other end's distance from the mean

/// The least difference of any two values that is not 0: the step of the converter, or finer.
double finestStep(std::span<const double> values)
{
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    double finest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (const double step = sorted[i] - sorted[i - 1]; step > 0) finest = std::min(finest, step);
    return finest;
}

/// A run of equal samples at the top, `sign` 1, or bottom, -1. A parabola through its neighbours would fall by
/// drop·((n-1)/(n+1))² within the run: a run is level where that is more than the converter's step.
bool isLevel(std::span<const double> values, double sign, double step)
{
    const auto higher = [sign](double a, double b) { return sign * a < sign * b; };
    const double top = *std::max_element(values.begin(), values.end(), higher);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != top) continue;
        std::size_t end = i;
        while (end < values.size() && values[end] == top) ++end;
        const std::size_t run = end - i;
        const bool has_flanks = i > 0 && end < values.size();
        if (run >= leastRun && has_flanks) {
            const double drop = sign * (top - 0.5 * (values[i - 1] + values[end]));
            const double inside = static_cast<double>(run - 1) / static_cast<double>(run + 1);
            if (drop * inside * inside > 2 * step) return true;
        }
        i = end;
    }
    return false;
}

}  // namespace

bool hasFlatTop(std::span<const double> values)
{
    if (values.size() < leastRun + 2) return false;
    const double step = finestStep(values);
    if (!std::isfinite(step)) return false;
    // A signal at rest is level too: only an end far from the mean can be that of a range.
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    const double above = *largest - mean, below = mean - *least;
    return (above >= farShare * below && isLevel(values, 1, step)) ||
           (below >= farShare * above && isLevel(values, -1, step));
}

}  // namespace lathelier::receptance
