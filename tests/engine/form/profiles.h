// Profiles made for the tests.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/core/random.h"

namespace lathelier::form {

using Points = std::vector<Eigen::Vector2d>;

/// `radius(angle)` at `count` angles from `first` over `turn`, uniform; a whole turn does not repeat its first point.
template <class Radius>
Points profileOf(std::size_t count, Radius radius, const Eigen::Vector2d& centre = Eigen::Vector2d::Zero(),
                 double turn = 2 * std::numbers::pi, double first = 0)
{
    const bool closed = turn > 6.28;
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = first + turn * static_cast<double>(i) / static_cast<double>(closed ? count : count - 1);
        points.push_back(centre + radius(t) * Eigen::Vector2d(std::cos(t), std::sin(t)));
    }
    return points;
}

/// Points at random angles over `turn`, at 1 ± spread / 2.
inline Points scattered(std::uint64_t seed, std::size_t count, double spread, double turn = 2 * std::numbers::pi)
{
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = turn * randomUniform(seed, 0, i);
        const double r = 1 + spread * (randomUniform(seed, 1, i) - 0.5);
        points.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    return points;
}

inline double zoneAbout(const Points& points, const Eigen::Vector2d& centre)
{
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const Eigen::Vector2d& point : points) {
        low = std::min(low, (point - centre).norm());
        high = std::max(high, (point - centre).norm());
    }
    return high - low;
}

inline double innerRadiusAbout(const Points& points, const Eigen::Vector2d& centre)
{
    double low = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& point : points) low = std::min(low, (point - centre).norm());
    return low;
}

}  // namespace lathelier::form
