// The only unit that sees CGAL: its flags (-frounding-math) stay with it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <iterator>

#include "engine/registration/surface/mesh_hole.h"

namespace lathelier::registration {

std::vector<std::array<std::uint32_t, 3>> fillHole(const std::vector<Eigen::Vector3d>& rim_mm)
{
    if (rim_mm.size() < 3) return {};
    if (rim_mm.size() == 3) return {{0, 1, 2}};
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    std::vector<Point> polyline;
    polyline.reserve(rim_mm.size());
    for (const Eigen::Vector3d& p : rim_mm) polyline.emplace_back(p.x(), p.y(), p.z());
    std::vector<CGAL::Triple<int, int, int>> found;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(polyline, std::back_inserter(found));
    if (found.size() + 2 != rim_mm.size()) return {};
    // Each edge of the rim belongs to one triangle: the one at the first edge determines the orientation of all.
    bool forward = false;
    for (const auto& t : found) {
        const std::array<int, 3> corners{t.first, t.second, t.third};
        for (std::size_t k = 0; k < 3; ++k) forward = forward || (corners[k] == 0 && corners[(k + 1) % 3] == 1);
    }
    std::vector<std::array<std::uint32_t, 3>> result;
    for (const auto& t : found) {
        result.push_back({static_cast<std::uint32_t>(t.first), static_cast<std::uint32_t>(t.second),
                          static_cast<std::uint32_t>(t.third)});
        if (!forward) std::swap(result.back()[1], result.back()[2]);
    }
    return result;
}

}  // namespace lathelier::registration
