#include <interpolation.h>

#include "tests/peers/circle_peers.h"

namespace lathelier::peers {
namespace {

alglib::real_2d_array toArray(std::span<const Eigen::Vector2d> points)
{
    alglib::real_2d_array array;
    array.setlength(static_cast<alglib::ae_int_t>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 2; ++k) array(static_cast<alglib::ae_int_t>(i), k) = points[i][k];
    return array;
}

template <class Fit>
Circle fitted(std::span<const Eigen::Vector2d> points, Fit fit)
{
    Circle circle;
    alglib::real_1d_array centre;
    fit(toArray(points), static_cast<alglib::ae_int_t>(points.size()), centre, circle);
    circle.centre = {centre[0], centre[1]};
    return circle;
}

}  // namespace

Circle alglibLeastSquares(std::span<const Eigen::Vector2d> points)
{
    return fitted(points, [](const auto& xy, auto n, auto& centre, Circle& c) {
        alglib::fitspherels(xy, n, 2, centre, c.outer);
    });
}

Circle alglibEnclosing(std::span<const Eigen::Vector2d> points)
{
    return fitted(points, [](const auto& xy, auto n, auto& centre, Circle& c) {
        alglib::fitspheremc(xy, n, 2, centre, c.outer);
    });
}

Circle alglibInscribed(std::span<const Eigen::Vector2d> points)
{
    return fitted(points, [](const auto& xy, auto n, auto& centre, Circle& c) {
        alglib::fitspheremi(xy, n, 2, centre, c.inner);
    });
}

Circle alglibMinimumZone(std::span<const Eigen::Vector2d> points)
{
    return fitted(points, [](const auto& xy, auto n, auto& centre, Circle& c) {
        alglib::fitspheremz(xy, n, 2, centre, c.inner, c.outer);
    });
}

}  // namespace lathelier::peers
