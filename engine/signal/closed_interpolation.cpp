#include "engine/signal/closed_interpolation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lathelier {
namespace {

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

ClosedInterpolation::ClosedInterpolation(const AngularSampling& sampling, const std::vector<double>& values)
    : angle_(sampling.angle_rad), values_(values), widest_(AngularSampling::gapFactor * sampling.median_spacing_rad)
{
}

double ClosedInterpolation::operator()(double angle_rad) const
{
    const std::size_t n = angle_.size();
    const double angle = angle_rad - turn * std::floor((angle_rad - angle_.front()) / turn);
    const auto above = std::upper_bound(angle_.begin(), angle_.end(), angle);
    const auto right = static_cast<std::ptrdiff_t>(above - angle_.begin());
    const double near = 1e-6 * turn / static_cast<double>(n);
    if (angle - angleAt(right - 1) <= near) return valueAt(right - 1);
    if (angleAt(right) - angle <= near) return valueAt(right);
    if (angleAt(right) - angleAt(right - 1) > widest_) return std::numeric_limits<double>::quiet_NaN();
    const bool cubic = n >= 5 && isRegular(right - 2) && isRegular(right - 1) && isRegular(right);
    const std::ptrdiff_t first = right - (cubic ? 2 : 1);
    const std::ptrdiff_t last = right + (cubic ? 1 : 0);
    double sum = 0;
    for (std::ptrdiff_t i = first; i <= last; ++i) {
        double weight = 1;  // Lagrange
        for (std::ptrdiff_t j = first; j <= last; ++j)
            if (j != i) weight *= (angle - angleAt(j)) / (angleAt(i) - angleAt(j));
        sum += weight * valueAt(i);
    }
    return sum;
}

std::size_t ClosedInterpolation::wrapped(std::ptrdiff_t i) const
{
    const auto n = static_cast<std::ptrdiff_t>(angle_.size());
    return static_cast<std::size_t>((i + n) % n);
}

double ClosedInterpolation::angleAt(std::ptrdiff_t i) const
{
    const auto n = static_cast<std::ptrdiff_t>(angle_.size());
    const double turns = i < 0 ? -1 : i >= n ? 1 : 0;
    return angle_[wrapped(i)] + turn * turns;
}

bool ClosedInterpolation::isRegular(std::ptrdiff_t left) const
{
    const double spacing = angleAt(left + 1) - angleAt(left);
    return spacing <= widest_ && spacing >= 0.01 * widest_;
}

}  // namespace lathelier
