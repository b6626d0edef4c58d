#include "engine/signal/closed_interpolation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/units.h"

namespace lathelier::signal {
namespace {

constexpr double evenEnough = 2;  ///< largest ratio of spacings for the cubic through four points

}  // namespace

ClosedInterpolation::ClosedInterpolation(const AngularSampling& sampling, const std::vector<double>& values)
    : angle_(sampling.angle_rad), values_(values), widest_(AngularSampling::gapFactor * sampling.median_spacing_rad)
{
}

double ClosedInterpolation::operator()(double angle_rad) const
{
    // Search started at the index expected for even spacing.
    const double turns = (angle_rad - angle_.front()) / turn_rad;
    auto place = static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(angle_.size()));
    return (*this)(angle_rad, place);
}

double ClosedInterpolation::operator()(double angle_rad, std::size_t& place) const
{
    const std::size_t n = angle_.size();
    const double angle = angle_rad - turn_rad * std::floor((angle_rad - angle_.front()) / turn_rad);
    place = firstBeyond(angle, place);
    const Neighbours p = about(place);
    const double near = 1e-6 * turn_rad / static_cast<double>(n);
    if (angle - p.angle[1] <= near) return p.value[1];
    if (p.angle[2] - angle <= near) return p.value[2];
    if (p.spacing(1) > widest_) return notANumber;
    const auto [narrowest, broadest] = std::minmax({p.spacing(0), p.spacing(1), p.spacing(2)});
    if (n < 5 || broadest > widest_) {
        const double share = (angle - p.angle[1]) / p.spacing(1);
        return (1 - share) * p.value[1] + share * p.value[2];
    }
    return broadest <= evenEnough * narrowest ? p.throughFour(angle) : p.monotone(angle);
}

/// std::upper_bound, started at `place`.
std::size_t ClosedInterpolation::firstBeyond(double angle, std::size_t place) const
{
    const std::size_t n = angle_.size();
    std::size_t low = std::min(place, n), high = low;
    for (std::size_t step = 1; low > 0 && angle_[low - 1] > angle; step *= 2) low -= std::min(low, step);
    for (std::size_t step = 1; high < n && !(angle_[high] > angle); step *= 2) high = std::min(n, high + step);
    const auto begin = angle_.begin();
    return static_cast<std::size_t>(
        std::upper_bound(begin + static_cast<std::ptrdiff_t>(low), begin + static_cast<std::ptrdiff_t>(high), angle) -
        begin);
}

/// Two points before the one at `right`, that one, and the next.
ClosedInterpolation::Neighbours ClosedInterpolation::about(std::size_t right) const
{
    const auto n = static_cast<std::ptrdiff_t>(angle_.size());
    Neighbours p;
    for (std::size_t k = 0; k < 4; ++k) {
        auto i = static_cast<std::ptrdiff_t>(right + k) - 2;
        const double turns = i < 0 ? -1 : i >= n ? 1 : 0;
        while (i < 0) i += n;
        while (i >= n) i -= n;
        p.angle[k] = angle_[static_cast<std::size_t>(i)] + turn_rad * turns;
        p.value[k] = values_[static_cast<std::size_t>(i)];
    }
    return p;
}

/// Lagrange's polynomial.
double ClosedInterpolation::Neighbours::throughFour(double at) const
{
    const auto [a, b, c, d] = angle;
    const double xa = at - a, xb = at - b, xc = at - c, xd = at - d;
    return value[0] * (xb * xc * xd) / ((a - b) * (a - c) * (a - d)) +
           value[1] * (xa * xc * xd) / ((b - a) * (b - c) * (b - d)) +
           value[2] * (xa * xb * xd) / ((c - a) * (c - b) * (c - d)) +
           value[3] * (xa * xb * xc) / ((d - a) * (d - b) * (d - c));
}

double ClosedInterpolation::Neighbours::slope(std::size_t i) const
{
    const double before = spacing(i - 1), after = spacing(i);
    if (!(before > 0) || !(after > 0)) return 0;  // two points at the same angle
    const double rise = (value[i] - value[i - 1]) / before, next = (value[i + 1] - value[i]) / after;
    if (rise * next <= 0) return 0;
    const double w = 2 * after + before, v = after + 2 * before;
    return (w + v) / (w / rise + v / next);
}

double ClosedInterpolation::Neighbours::monotone(double at) const
{
    const double width = spacing(1), s = (at - angle[1]) / width;
    return (1 + 2 * s) * (1 - s) * (1 - s) * value[1] + s * s * (3 - 2 * s) * value[2] +
           width * s * (1 - s) * ((1 - s) * slope(1) - s * slope(2));
}

}  // namespace lathelier::signal
