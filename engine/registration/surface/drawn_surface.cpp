#include "engine/registration/surface/drawn_surface.h"

#include <cmath>

namespace lathelier::registration {
namespace {

constexpr double anyDistance_mm = 1e9;  // place() limits the distance for each call

}  // namespace

SurfacePlace placeOn(const ContourDistance& distance, const Eigen::Vector3d& point_mm)
{
    SurfacePlace place;
    const double r = std::hypot(point_mm.x(), point_mm.y());
    const auto foot = distance.footOf(point_mm.z(), r);
    if (!foot) return place;
    place.distance_mm = foot->distance_mm;
    const Eigen::Vector2d across = r > 0 ? Eigen::Vector2d(point_mm.head<2>() / r) : Eigen::Vector2d::UnitX();
    place.normal = {foot->outward.y() * across.x(), foot->outward.y() * across.y(), foot->outward.x()};
    return place;
}

DrawnSurface::DrawnSurface(const Contour& meridian, const Eigen::Vector3d& middle_mm)
    : distance_(meridian, anyDistance_mm), middle_mm_(middle_mm)
{
}

void DrawnSurface::place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm,
                         std::span<SurfacePlace> places, std::span<Trace>) const
{
    for (std::size_t q = 0; q < queries_mm.size(); ++q) {
        places[q] = placeOn(distance_, queries_mm[q] + middle_mm_);
        if (!(std::abs(places[q].distance_mm) <= max_distance_mm)) places[q] = {};
    }
}

}  // namespace lathelier::registration
