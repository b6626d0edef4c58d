#include <cmath>
#include <limits>

#include "engine/form/circle_simple.h"

namespace lathelier {
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

/// Smallest enclosing circle of at most four points, by trying every pair and triple.
EnclosingCircle smallestOfFew(const CirclePoints& points, const std::vector<std::size_t>& few)
{
    EnclosingCircle best;
    best.radius = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Disc& disc, std::vector<std::size_t> contacts) {
        if (!(disc.radius < best.radius)) return;
        for (const std::size_t i : few)
            if ((points.point(i) - disc.centre).norm() > disc.radius * (1 + 4e-16)) return;
        best = {disc.centre, disc.radius, std::move(contacts)};
    };
    for (std::size_t i = 0; i < few.size(); ++i)
        for (std::size_t j = i + 1; j < few.size(); ++j) {
            consider(through(points.point(few[i]), points.point(few[j])), {few[i], few[j]});
            for (std::size_t k = j + 1; k < few.size(); ++k)
                consider(through(points.point(few[i]), points.point(few[j]), points.point(few[k])),
                         {few[i], few[j], few[k]});
        }
    return best;
}

}  // namespace

EnclosingCircle enclosingCircle(const CirclePoints& points)
{
    const std::size_t first = points.extremes(Eigen::Vector2d::Zero()).farthest_index;
    const std::size_t second = points.extremes(points.point(first)).farthest_index;
    EnclosingCircle circle = smallestOfFew(points, {first, second});
    for (int iteration = 0; iteration < 1000; ++iteration) {
        const CirclePoints::Extremes e = points.extremes(circle.centre);
        if (e.farthest <= circle.radius * (1 + 1e-15)) break;
        std::vector<std::size_t> few = circle.contacts;
        few.push_back(e.farthest_index);
        EnclosingCircle next = smallestOfFew(points, few);
        if (!(next.radius > circle.radius)) break;  // no more than rounding is left
        circle = std::move(next);
    }
    return circle;
}

}  // namespace lathelier
