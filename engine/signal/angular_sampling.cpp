#include "engine/signal/angular_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/core/statistics.h"
#include "engine/signal/hampel.h"

namespace lathelier::signal {
namespace {

constexpr double turn = 2 * std::numbers::pi;

constexpr double shareOfSpacing = 0.9;  ///< order × spacing / π: below 1 the weights bound the condition
constexpr double mostLeakage = 0.1;

/// Places of the values in ascending order; equal values keep the order given.
std::vector<std::size_t> ascending(const std::vector<double>& values)
{
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (values.empty()) return order;
    // One turn in the order measured begins anywhere and is in order from there.
    const auto turned = std::is_sorted_until(values.begin(), values.end());
    if (turned == values.end()) return order;
    if (values.back() < values.front() && std::is_sorted(turned, values.end())) {
        std::rotate(order.begin(), order.begin() + (turned - values.begin()), order.end());
        return order;
    }
    std::vector<std::pair<double, std::size_t>> pairs(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) pairs[i] = {values[i], i};
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < values.size(); ++i) order[i] = pairs[i].second;
    return order;
}

/// Largest distance of ascending different angles from evenly spaced ones, in their spacing.
double displacementOf(const std::vector<double>& angle)
{
    const auto n = static_cast<double>(angle.size());
    const double step = turn / n;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t i = 0; i < angle.size(); ++i) {
        const double off = angle[i] - static_cast<double>(i) * step;
        least = std::min(least, off);
        most = std::max(most, off);
    }
    return (most - least) / (2 * step);
}

}  // namespace

AngularSampling sampleAngles(std::span<const double> angle_rad)
{
    AngularSampling result;
    const std::size_t n = angle_rad.size();
    std::vector<double> wrapped(n);
    for (std::size_t i = 0; i < n; ++i) wrapped[i] = angle_rad[i] - turn * std::floor(angle_rad[i] / turn);
    result.order = ascending(wrapped);
    result.angle_rad = inOrder(result, wrapped);

    std::vector<double> spacing(n), different, place;
    for (std::size_t i = 0; i < n; ++i) {
        const double next = i + 1 < n ? result.angle_rad[i + 1] : result.angle_rad[0] + turn;
        spacing[i] = next - result.angle_rad[i];
        if (spacing[i] <= 1e-9 * turn / static_cast<double>(n)) continue;
        different.push_back(spacing[i]);
        place.push_back(result.angle_rad[i]);
    }
    result.different = different.size();
    result.largest_gap_rad = *std::max_element(spacing.begin(), spacing.end());
    result.median_spacing_rad = median(different);
    const double gap = AngularSampling::gapFactor * result.median_spacing_rad;
    for (const double s : different) {
        if (s > gap) {
            ++result.gaps;
            result.missing_rad += s - result.median_spacing_rad;
        } else {
            result.largest_regular_rad = std::max(result.largest_regular_rad, s);
        }
    }
    // A point near 2π that belongs before the first would spoil the comparison with even steps.
    if (place.size() > 1 && different.back() < 0.5 * turn / static_cast<double>(place.size())) {
        place.insert(place.begin(), place.back() - turn);
        place.pop_back();
    }
    result.displacement = displacementOf(place);
    result.uniform = result.different == n && result.displacement < 1e-6;
    if (result.uniform) result.displacement = 0;

    const double widest = 3 * result.median_spacing_rad;
    result.weight.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double before = spacing[(i + n - 1) % n], after = spacing[i];
        result.weight[i] = (std::min(before, widest) + std::min(after, widest)) / (2 * turn);
    }
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
    // Nearly even samples tell of their last order what they see of it.
    result.estimated = sampling.displacement <= AngularSampling::nearlyEven ? different / 2 : result.determined;
    result.leakage = sampling.missing_rad / (turn - sampling.missing_rad);
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
