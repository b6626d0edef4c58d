#include "engine/form/roundness/drawn_changes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"

namespace lathelier::form {
namespace {

/// Coverage among the draws that yields 95 % when the form under the noise is itself an estimate.
constexpr double coverage = 0.975;

/// Half-width about 0 that holds the `coverage` of a normal distribution.
double halfWidth(double mean, double deviation)
{
    const auto inside = [&](double half) {
        const auto below = [&](double x) { return 0.5 * std::erfc((mean - x) / (deviation * std::numbers::sqrt2)); };
        return below(half) - below(-half);
    };
    double low = 0, high = std::abs(mean) + 6 * deviation;
    if (!(deviation > 0)) return high;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (inside(middle) < coverage ? low : high) = middle;
    }
    return high;
}

}  // namespace

double coverageHalfWidth(std::vector<double> changes, double relative_u)
{
    const auto n = static_cast<double>(changes.size());
    double mean = 0, squares = 0;
    for (const double change : changes) mean += change / n;
    for (const double change : changes) squares += (change - mean) * (change - mean) / (n - 1);
    const double normal = halfWidth(mean, std::hypot(std::sqrt(squares), relative_u * mean));
    for (double& change : changes) change = std::abs(change);
    return std::max(normal, lowerQuantileInPlace(changes, coverage));
}

}  // namespace lathelier::form
