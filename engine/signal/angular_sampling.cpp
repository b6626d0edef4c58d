#include "engine/signal/angular_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/signal/hampel.h"

namespace lathelier::signal {
namespace {

constexpr double shareOfSpacing = 0.9;  ///< order × spacing / π: below 1 the adaptive weights bound the condition
                                        ///< number
constexpr double mostLeakage = 0.1;

using Placed = std::pair<double, std::size_t>;

/// Sorts by insertion; false, with the order incomplete, when more than a few steps per value are needed.
bool sortNearlySorted(std::vector<Placed>& pairs)
{
    std::size_t left = 4 * pairs.size();
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        const Placed pair = pairs[i];
        std::size_t to = i;
        for (; to > 0 && pair < pairs[to - 1] && left > 0; --to, --left) pairs[to] = pairs[to - 1];
        pairs[to] = pair;
        if (left == 0) return false;
    }
    return true;
}

/// Indices of the values in ascending order; equal values keep the order given.
std::vector<std::size_t> ascending(const std::vector<double>& values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (values.empty()) return order;
    // One revolution in measured order is sorted up to a rotation.
    const auto turned = std::is_sorted_until(values.begin(), values.end());
    if (turned == values.end()) return order;
    if (values.back() < values.front() && std::is_sorted(turned, values.end())) {
        std::rotate(order.begin(), order.begin() + (turned - values.begin()), order.end());
        return order;
    }
    // Noise may exchange neighbours.
    std::vector<Placed> pairs(values.size());
    const auto first = static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t place = first + i < values.size() ? first + i : first + i - values.size();
        pairs[i] = {values[place], place};
    }
    if (!sortNearlySorted(pairs)) std::sort(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < values.size(); ++i) order[i] = pairs[i].second;
    return order;
}

/// Whether two angles at this distance are distinct among n.
bool areTwo(double spacing, std::size_t n)
{
    return !(spacing <= 1e-9 * turn_rad / static_cast<double>(n));
}

/// Largest distance of the `different` angles from evenly spaced ones, in their spacing.
double displacementOf(const AngularSampling& sampling)
{
    const std::vector<double>& angle = sampling.angle_rad;
    const std::size_t n = angle.size();
    const double step = turn_rad / static_cast<double>(sampling.different);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    double place = 0;
    const auto count = [&](double at) {
        const double off = at - place * step;
        least = std::min(least, off);
        most = std::max(most, off);
        ++place;
    };
    std::size_t last = n;  // index of the last distinct angle
    double spacing = 0;
    while (last-- > 0) {
        spacing = (last + 1 < n ? angle[last + 1] : angle[0] + turn_rad) - angle[last];
        if (areTwo(spacing, n)) break;
    }
    // A point near 2π that precedes the first is moved, for the comparison with even steps.
    const bool before = sampling.different > 1 && spacing < 0.5 * step;
    if (before) count(angle[last] - turn_rad);
    for (std::size_t i = 0; i < last; ++i)
        if (areTwo(angle[i + 1] - angle[i], n)) count(angle[i]);
    if (!before) count(angle[last]);
    return (most - least) / (2 * step);
}

}  // namespace

AngularSampling sampleAngles(std::span<const double> angle_rad)
{
    AngularSampling result;
    const std::size_t n = angle_rad.size();
    std::vector<double> wrapped(n);
    for (std::size_t i = 0; i < n; ++i) wrapped[i] = angle_rad[i] - turn_rad * std::floor(angle_rad[i] / turn_rad);
    result.order = ascending(wrapped);
    result.angle_rad = inOrder(result, wrapped);
    wrapped = {};

    const auto spacingAfter = [&](std::size_t i) {
        return (i + 1 < n ? result.angle_rad[i + 1] : result.angle_rad[0] + turn_rad) - result.angle_rad[i];
    };
    std::vector<double> different;
    different.reserve(n);
    result.largest_gap_rad = spacingAfter(n - 1);
    for (std::size_t i = 0; i < n; ++i) {
        const double spacing = spacingAfter(i);
        result.largest_gap_rad = std::max(result.largest_gap_rad, spacing);
        if (areTwo(spacing, n)) different.push_back(spacing);
    }
    result.different = different.size();
    result.median_spacing_rad = median(std::move(different));
    const double gap = AngularSampling::gapFactor * result.median_spacing_rad;
    const double widest = 3 * result.median_spacing_rad;
    result.weight.resize(n);
    double before = spacingAfter(n - 1);
    for (std::size_t i = 0; i < n; ++i) {
        const double after = spacingAfter(i);
        result.weight[i] = (std::min(before, widest) + std::min(after, widest)) / (2 * turn_rad);
        before = after;
        if (after > gap) {
            ++result.gaps;
            result.missing_rad += after - result.median_spacing_rad;
        } else if (areTwo(after, n)) {
            result.largest_regular_rad = std::max(result.largest_regular_rad, after);
        }
    }
    result.displacement = displacementOf(result);
    result.uniform = result.different == n && result.displacement < 1e-6;
    if (result.uniform) result.displacement = 0;
    return result;
}

CarriedOrders carriedOrders(const AngularSampling& sampling)
{
    CarriedOrders result;
    const auto different = static_cast<int>(sampling.different);
    const auto below = [&](double spacing_rad) {
        return std::min((different - 1) / 2, static_cast<int>(shareOfSpacing * std::numbers::pi / spacing_rad));
    };
    result.determined = sampling.displacement <= AngularSampling::nearlyEven ? std::max(0, (different - 1) / 2)
                                                                             : below(sampling.largest_gap_rad);
    // For nearly even samples the order n/2 is estimated as far as it is observable.
    result.estimated = sampling.displacement <= AngularSampling::nearlyEven ? different / 2 : result.determined;
    result.leakage = sampling.missing_rad / (turn_rad - sampling.missing_rad);
    if (sampling.gaps > 0 && result.leakage <= mostLeakage)
        result.estimated = std::max(result.determined, below(sampling.largest_regular_rad));
    return result;
}

std::vector<double> inOrder(const AngularSampling& sampling, std::span<const double> values)
{
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) result[i] = values[sampling.order[i]];
    return result;
}

}  // namespace lathelier::signal
