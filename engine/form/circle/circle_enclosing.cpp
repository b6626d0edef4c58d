#include "engine/form/circle/circle_enclosing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::form {
namespace {

struct Disc {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = std::numeric_limits<double>::infinity();
};

Disc through(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return {0.5 * (a + b), 0.5 * (a - b).norm()};
}

Disc through(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    const Eigen::Vector2d u = b - a, v = c - a;
    const double cross = 2 * (u.x() * v.y() - u.y() * v.x());
    if (cross == 0) return {};
    const Eigen::Vector2d w((v.y() * u.squaredNorm() - u.y() * v.squaredNorm()) / cross,
                            (u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / cross);
    const Eigen::Vector2d centre = a + w;
    return {centre, std::max({(a - centre).norm(), (b - centre).norm(), (c - centre).norm()})};
}

/// Smallest enclosing circle of two to four points, by trying every pair and triple. `at(index)` is a point.
template <class At>
EnclosingCircle smallestOfFew(At at, const std::vector<std::size_t>& few)
{
    EnclosingCircle best;
    best.radius = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Disc& disc, std::vector<std::size_t> contacts) {
        if (!(disc.radius < best.radius)) return;
        for (const std::size_t i : few)
            if ((at(i) - disc.centre).norm() > disc.radius * (1 + 4e-16)) return;
        best = {disc.centre, disc.radius, std::move(contacts)};
    };
    for (std::size_t i = 0; i < few.size(); ++i)
        for (std::size_t j = i + 1; j < few.size(); ++j) {
            consider(through(at(few[i]), at(few[j])), {few[i], few[j]});
            for (std::size_t k = j + 1; k < few.size(); ++k)
                consider(through(at(few[i]), at(few[j]), at(few[k])), {few[i], few[j], few[k]});
        }
    return best;
}

/// `farthest(centre)` is the index of the point farthest from a centre.
template <class At, class Farthest>
EnclosingCircle grow(At at, Farthest farthest)
{
    const std::size_t first = farthest(Eigen::Vector2d(at(0)));
    const std::size_t second = farthest(Eigen::Vector2d(at(first)));
    if (first == second) return {at(first), 0, {first}};
    EnclosingCircle circle = smallestOfFew(at, {first, second});
    for (int iteration = 0; iteration < 1000; ++iteration) {
        const std::size_t index = farthest(circle.centre);
        if ((at(index) - circle.centre).norm() <= circle.radius * (1 + 1e-15)) break;
        std::vector<std::size_t> few = circle.contacts;
        few.push_back(index);
        EnclosingCircle next = smallestOfFew(at, few);
        if (!(next.radius > circle.radius)) break;  // no increase beyond rounding
        circle = std::move(next);
    }
    return circle;
}

}  // namespace

EnclosingCircle enclosingCircle(const CirclePoints& points)
{
    return grow([&](std::size_t i) { return points.point(i); },
                [&](const Eigen::Vector2d& centre) { return points.extremes(centre).farthest_index; });
}

EnclosingCircle enclosingCircle(std::span<const Eigen::Vector2d> points)
{
    return grow(
        [&](std::size_t i) { return points[i]; },
        [&](const Eigen::Vector2d& centre) {
            const auto nearer = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                return (a - centre).squaredNorm() < (b - centre).squaredNorm();
            };
            return static_cast<std::size_t>(std::max_element(points.begin(), points.end(), nearer) - points.begin());
        });
}

}  // namespace lathelier::form
