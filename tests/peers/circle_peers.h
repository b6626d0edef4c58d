// Other libraries' answers to the questions of engine/form/circle/circles.h, for tests and benchmarks where they are
// installed: LATHELIER_WITH_CGAL, LATHELIER_WITH_ALGLIB.
#pragma once

#include <Eigen/Core>
#include <span>

namespace lathelier::peers {

struct Circle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double inner = 0, outer = 0;  ///< one of them where the question has only one
};

/// CGAL Min_sphere_of_spheres_d: the smallest enclosing circle.
Circle cgalEnclosing(std::span<const Eigen::Vector2d> points);
/// CGAL Min_annulus_d: the annulus of the smallest Ro² - Ri², which is not the narrowest.
Circle cgalAnnulus(std::span<const Eigen::Vector2d> points);

/// ALGLIB fitspherels, -mc, -mi, -mz. The inscribed one has no bound on its centre: near-round whole turns only.
Circle alglibLeastSquares(std::span<const Eigen::Vector2d> points);
Circle alglibEnclosing(std::span<const Eigen::Vector2d> points);
Circle alglibInscribed(std::span<const Eigen::Vector2d> points);
Circle alglibMinimumZone(std::span<const Eigen::Vector2d> points);

}  // namespace lathelier::peers
