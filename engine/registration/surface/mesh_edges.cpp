#include "engine/registration/surface/mesh_edges.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lathelier::registration {

std::vector<MeshEdge> edgesOf(std::span<const TriangleCorners> triangles)
{
    std::vector<MeshEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint8_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[t][k];
            const std::uint32_t b = triangles[t][(k + 1U) % 3];
            if (a != b) edges.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), t, k, a < b});
        }
    std::sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b) {
        return std::tie(a.corners, a.triangle, a.side) < std::tie(b.corners, b.triangle, b.side);
    });
    return edges;
}

CornerNumbers numberCorners(const std::vector<Eigen::Vector3d>& points_mm)
{
    std::vector<std::uint32_t> order(points_mm.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(points_mm[a].x(), points_mm[a].y(), points_mm[a].z(), a) <
               std::tie(points_mm[b].x(), points_mm[b].y(), points_mm[b].z(), b);
    };
    std::sort(order.begin(), order.end(), before);
    CornerNumbers numbers;
    numbers.of_vertex.resize(points_mm.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && points_mm[order[i]] != points_mm[order[i - 1]]) ++numbers.count;
        numbers.of_vertex[order[i]] = numbers.count;
    }
    if (!points_mm.empty()) ++numbers.count;
    return numbers;
}

}  // namespace lathelier::registration
