#include "engine/signal/closed_interpolation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lathelier::signal {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double evenEnough = 2;  ///< largest over smallest spacing that a cubic through four points takes

}  // namespace

ClosedInterpolation::ClosedInterpolation(const AngularSampling& sampling, const std::vector<double>& values)
    : angle_(sampling.angle_rad), values_(values), widest_(AngularSampling::gapFactor * sampling.median_spacing_rad)
{
}

double ClosedInterpolation::operator()(double angle_rad) const
{
    const std::size_t n = angle_.size();
    const double angle = angle_rad - turn * std::floor((angle_rad - angle_.front()) / turn);
    const std::ptrdiff_t right = firstBeyond(angle);
    const double near = 1e-6 * turn / static_cast<double>(n);
    if (angle - angleAt(right - 1) <= near) return valueAt(right - 1);
    if (angleAt(right) - angle <= near) return valueAt(right);
    if (angleAt(right) - angleAt(right - 1) > widest_) return std::numeric_limits<double>::quiet_NaN();
    const std::ptrdiff_t left = right - 1;
    const auto [narrowest, broadest] = std::minmax({spacingAt(left - 1), spacingAt(left), spacingAt(left + 1)});
    if (n < 5 || broadest > widest_) {
        const double share = (angle - angleAt(left)) / spacingAt(left);
        return (1 - share) * valueAt(left) + share * valueAt(right);
    }
    return broadest <= evenEnough * narrowest ? throughFour(left - 1, angle) : monotone(left, angle);
}

/// std::upper_bound, begun where even spacing would have the place.
std::ptrdiff_t ClosedInterpolation::firstBeyond(double angle) const
{
    const auto n = static_cast<std::ptrdiff_t>(angle_.size());
    const double share = (angle - angle_.front()) / turn;
    const auto guess = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(share * static_cast<double>(n)), 0, n);
    std::ptrdiff_t low = guess, high = guess;
    for (std::ptrdiff_t step = 1; low > 0 && angle_[static_cast<std::size_t>(low) - 1] > angle; step *= 2)
        low = std::max<std::ptrdiff_t>(0, low - step);
    for (std::ptrdiff_t step = 1; high < n && !(angle_[static_cast<std::size_t>(high)] > angle); step *= 2)
        high = std::min(n, high + step);
    return std::upper_bound(angle_.begin() + low, angle_.begin() + high, angle) - angle_.begin();
}

/// Lagrange's polynomial.
double ClosedInterpolation::throughFour(std::ptrdiff_t first, double angle) const
{
    const double a = angleAt(first), b = angleAt(first + 1), c = angleAt(first + 2), d = angleAt(first + 3);
    const double xa = angle - a, xb = angle - b, xc = angle - c, xd = angle - d;
    return valueAt(first) * (xb * xc * xd) / ((a - b) * (a - c) * (a - d)) +
           valueAt(first + 1) * (xa * xc * xd) / ((b - a) * (b - c) * (b - d)) +
           valueAt(first + 2) * (xa * xb * xd) / ((c - a) * (c - b) * (c - d)) +
           valueAt(first + 3) * (xa * xb * xc) / ((d - a) * (d - b) * (d - c));
}

double ClosedInterpolation::slopeAt(std::ptrdiff_t i) const
{
    const double before = spacingAt(i - 1), after = spacingAt(i);
    if (!(before > 0) || !(after > 0)) return 0;  // two points at one angle
    const double rise = (valueAt(i) - valueAt(i - 1)) / before, next = (valueAt(i + 1) - valueAt(i)) / after;
    if (rise * next <= 0) return 0;
    const double w = 2 * after + before, v = after + 2 * before;
    return (w + v) / (w / rise + v / next);
}

double ClosedInterpolation::monotone(std::ptrdiff_t left, double angle) const
{
    const double width = spacingAt(left), s = (angle - angleAt(left)) / width;
    const double a = valueAt(left), b = valueAt(left + 1);
    return (1 + 2 * s) * (1 - s) * (1 - s) * a + s * s * (3 - 2 * s) * b +
           width * s * (1 - s) * ((1 - s) * slopeAt(left) - s * slopeAt(left + 1));
}

std::size_t ClosedInterpolation::wrapped(std::ptrdiff_t i) const
{
    const auto n = static_cast<std::ptrdiff_t>(angle_.size());
    while (i < 0) i += n;
    while (i >= n) i -= n;
    return static_cast<std::size_t>(i);
}

double ClosedInterpolation::angleAt(std::ptrdiff_t i) const
{
    const auto n = static_cast<std::ptrdiff_t>(angle_.size());
    const double turns = i < 0 ? -1 : i >= n ? 1 : 0;
    return angle_[wrapped(i)] + turn * turns;
}

}  // namespace lathelier::signal
