#include "engine/form/circle/circle_region.h"

#include <algorithm>
#include <cmath>

#include "engine/form/circle/plane_cross.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;

/// Corners of the convex hull, anticlockwise (Andrew's monotone chain).
std::vector<Vector2d> monotoneHull(std::vector<Vector2d> points)
{
    std::sort(points.begin(), points.end(),
              [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
    std::vector<Vector2d> corners(2 * points.size());
    std::size_t count = 0;
    const auto turn = [&](const Vector2d& point, std::size_t least) {
        while (count >= least && cross(corners[count - 1] - corners[count - 2], point - corners[count - 2]) <= 0)
            --count;
        corners[count++] = point;
    };
    for (const Vector2d& point : points) turn(point, 2);
    const std::size_t lower = count + 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point) turn(*point, lower);
    corners.resize(count > 1 ? count - 1 : count);
    return corners;
}

std::vector<HalfPlane> edgesOf(const std::vector<Vector2d>& corners)
{
    std::vector<HalfPlane> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector2d along = corners[(i + 1) % corners.size()] - corners[i];
        if (along.isZero(0)) continue;
        const Vector2d normal = Vector2d(along.y(), -along.x()).normalized();
        edges.push_back({normal, normal.dot(corners[i])});
    }
    return edges;
}

}  // namespace

std::vector<HalfPlane> inscribedRegion(const CirclePoints& points, const Vector2d& centre,
                                       const std::array<CirclePoints::Sector, CirclePoints::sectorCount>& sectors)
{
    std::vector<Vector2d> some;
    for (const CirclePoints::Sector& sector : sectors)
        if (sector.occupied) some.push_back(points.point(sector.farthest_index));
    const double radius = points.extremes(centre).nearest;
    const std::vector<Vector2d> corners = monotoneHull(some);
    std::vector<HalfPlane> edges = edgesOf(corners);
    bool close = corners.size() >= 3;
    for (std::size_t i = 0; i < corners.size() && close; ++i)
        close = (corners[(i + 1) % corners.size()] - corners[i]).norm() < 0.3 * radius;
    for (const HalfPlane& edge : edges) close = close && edge.normal.dot(centre) < edge.offset;
    if (close) return edges;

    std::vector<Vector2d> all(points.size() + 1);
    for (std::size_t i = 0; i < points.size(); ++i) all[i] = points.point(i);
    all.back() = centre;
    return edgesOf(monotoneHull(std::move(all)));
}

}  // namespace lathelier::form
