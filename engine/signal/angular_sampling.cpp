#include "engine/signal/angular_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/signal/hampel.h"

namespace lathelier {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Evenly spaced but for rounding: the filter by index is then exact.
bool isUniform(const std::vector<double>& angle)
{
    const auto n = static_cast<double>(angle.size());
    const double step = turn / n;
    double sum = 0;
    for (std::size_t i = 0; i < angle.size(); ++i) sum += angle[i] - static_cast<double>(i) * step;
    const double start = sum / n;
    for (std::size_t i = 0; i < angle.size(); ++i)
        if (std::abs(angle[i] - start - static_cast<double>(i) * step) > 1e-6 * step) return false;
    return true;
}

}  // namespace

AngularSampling sampleAngles(std::span<const double> angle_rad)
{
    AngularSampling result;
    const std::size_t n = angle_rad.size();
    std::vector<double> wrapped(n);
    for (std::size_t i = 0; i < n; ++i) wrapped[i] = angle_rad[i] - turn * std::floor(angle_rad[i] / turn);
    result.order.resize(n);
    std::iota(result.order.begin(), result.order.end(), std::size_t{0});
    std::stable_sort(result.order.begin(), result.order.end(),
                     [&](std::size_t a, std::size_t b) { return wrapped[a] < wrapped[b]; });
    result.angle_rad = inOrder(result, wrapped);

    std::vector<double> spacing(n), different;
    for (std::size_t i = 0; i < n; ++i) {
        const double next = i + 1 < n ? result.angle_rad[i + 1] : result.angle_rad[0] + turn;
        spacing[i] = next - result.angle_rad[i];
        if (spacing[i] > 1e-9 * turn / static_cast<double>(n)) different.push_back(spacing[i]);
    }
    result.different = different.size();
    result.largest_gap_rad = *std::max_element(spacing.begin(), spacing.end());
    result.median_spacing_rad = median(different);
    const double gap = AngularSampling::gapFactor * result.median_spacing_rad;
    result.gaps =
        static_cast<std::size_t>(std::count_if(spacing.begin(), spacing.end(), [&](double s) { return s > gap; }));
    // A point near 2π that belongs before the first would spoil the comparison with even steps.
    std::vector<double> cut = result.angle_rad;
    if (n > 1 && spacing.back() < 0.5 * turn / static_cast<double>(n)) {
        cut.insert(cut.begin(), cut.back() - turn);
        cut.pop_back();
    }
    result.uniform = result.different == n && isUniform(cut);

    const double widest = 3 * result.median_spacing_rad;
    result.weight.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double before = spacing[(i + n - 1) % n], after = spacing[i];
        result.weight[i] = (std::min(before, widest) + std::min(after, widest)) / (2 * turn);
    }
    return result;
}

std::vector<double> inOrder(const AngularSampling& sampling, std::span<const double> values)
{
    std::vector<double> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) result[i] = values[sampling.order[i]];
    return result;
}

}  // namespace lathelier
