#include "engine/signal/hampel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/parallel.h"

namespace lathelier {
namespace {

constexpr double normalPerMedian = 1.4826;

constexpr std::size_t grain = 8192;

/// Median of `values`, which are left in another order.
double medianInPlace(std::vector<double>& values)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// Fills `window` with the finite values about index `i`.
void takeWindow(std::span<const double> values, std::ptrdiff_t i, const HampelOptions& options,
                std::vector<double>& window)
{
    const auto n = static_cast<std::ptrdiff_t>(values.size());
    const std::ptrdiff_t half = std::min<std::ptrdiff_t>(options.half_window, (n - 1) / 2);
    window.clear();
    for (std::ptrdiff_t j = i - half; j <= i + half; ++j) {
        if (!options.closed && (j < 0 || j >= n)) continue;
        const double value = values[static_cast<std::size_t>(j < 0 ? j + n : j >= n ? j - n : j)];
        if (std::isfinite(value)) window.push_back(value);
    }
}

}  // namespace

double median(std::vector<double> values)
{
    return medianInPlace(values);
}

double robustSpread(const std::vector<double>& values)
{
    const double centre = median(values);
    std::vector<double> distances;
    distances.reserve(values.size());
    for (const double value : values) distances.push_back(std::abs(value - centre));
    return normalPerMedian * median(std::move(distances));
}

std::vector<std::uint8_t> hampelOutliers(std::span<const double> values, const HampelOptions& options,
                                         const Progress& progress)
{
    std::vector<std::uint8_t> result(values.size(), 0);
    std::vector<double> distance(values.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<double> spread(values.size(), 0.0);
    std::vector<double> finite;
    const bool moving = options.half_window > 0;
    std::vector<double> whole;
    if (!moving)
        std::copy_if(values.begin(), values.end(), std::back_inserter(whole),
                     [](double v) { return std::isfinite(v); });
    const double centre = moving ? 0 : median(whole);
    parallelFor(values.size(), grain, progress, [&](std::size_t begin, std::size_t end) {
        std::vector<double> window;
        for (std::size_t i = begin; i < end; ++i) {
            if (!std::isfinite(values[i])) continue;
            double middle = centre;
            if (moving) {
                takeWindow(values, static_cast<std::ptrdiff_t>(i), options, window);
                middle = medianInPlace(window);
                for (double& value : window) value = std::abs(value - middle);
                spread[i] = normalPerMedian * medianInPlace(window);
            }
            distance[i] = std::abs(values[i] - middle);
        }
    });
    for (const double d : distance)
        if (std::isfinite(d)) finite.push_back(d);
    const double overall = std::max(normalPerMedian * median(finite), options.least_spread);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double limit = options.threshold * std::max(spread[i], overall);
        // The last bits of equal values are no outliers.
        const double rounding = 1e-12 * std::abs(values[i]);
        result[i] = !(distance[i] <= limit + rounding);
    }
    return result;
}

}  // namespace lathelier
