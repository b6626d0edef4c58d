#include <CGAL/Cartesian.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Min_annulus_d.h>
#include <CGAL/Min_sphere_annulus_d_traits_2.h>
#include <CGAL/Min_sphere_of_points_d_traits_2.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

#include "tests/peers/circle_peers.h"

namespace lathelier::peers {

Circle cgalEnclosing(std::span<const Eigen::Vector2d> points)
{
    using Kernel = CGAL::Simple_cartesian<double>;
    using Traits = CGAL::Min_sphere_of_points_d_traits_2<Kernel, double>;
    std::vector<Kernel::Point_2> given;
    for (const Eigen::Vector2d& point : points) given.emplace_back(point.x(), point.y());
    CGAL::Min_sphere_of_spheres_d<Traits> sphere(given.begin(), given.end());
    const double* centre = &*sphere.center_cartesian_begin();
    return {{centre[0], centre[1]}, 0, sphere.radius()};
}

Circle cgalAnnulus(std::span<const Eigen::Vector2d> points)
{
    using Kernel = CGAL::Simple_cartesian<double>;
    using Traits = CGAL::Min_sphere_annulus_d_traits_2<Kernel, CGAL::MP_Float, double>;
    std::vector<Kernel::Point_2> given;
    for (const Eigen::Vector2d& point : points) given.emplace_back(point.x(), point.y());
    const CGAL::Min_annulus_d<Traits> annulus(given.begin(), given.end());
    auto coordinate = annulus.center_coordinates_begin();
    const double x = CGAL::to_double(*coordinate++), y = CGAL::to_double(*coordinate++);
    const double scale = CGAL::to_double(*coordinate);  // homogeneous
    return {{x / scale, y / scale},
            std::sqrt(CGAL::to_double(annulus.squared_inner_radius_numerator()) /
                      CGAL::to_double(annulus.squared_radii_denominator())),
            std::sqrt(CGAL::to_double(annulus.squared_outer_radius_numerator()) /
                      CGAL::to_double(annulus.squared_radii_denominator()))};
}

}  // namespace lathelier::peers
