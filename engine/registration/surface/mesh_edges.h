// The edges of a mesh, and which triangles meet at each.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace lathelier::registration {

using TriangleCorners = std::array<std::uint32_t, 3>;

/// One side of a triangle. Sides of the same edge have equal `corners`.
struct MeshEdge {
    std::uint64_t corners;   ///< smaller number in the upper half
    std::uint32_t triangle;  ///< index of the triangle
    std::uint8_t side;       ///< from corner `side` to the next
    bool forward;            ///< from the smaller number to the larger

    std::uint32_t low() const { return static_cast<std::uint32_t>(corners >> 32); }
    std::uint32_t high() const { return static_cast<std::uint32_t>(corners); }
};

/// All sides but those between equal corners, those of one edge beside each other, in order of their triangles.
std::vector<MeshEdge> edgesOf(std::span<const TriangleCorners> triangles);

/// One number for all vertices with the same coordinates, 0…count-1.
struct CornerNumbers {
    std::vector<std::uint32_t> of_vertex;  ///< by index of the vertex
    std::uint32_t count = 0;               ///< number of different places

    TriangleCorners of(const TriangleCorners& triangle) const
    {
        return {of_vertex[triangle[0]], of_vertex[triangle[1]], of_vertex[triangle[2]]};
    }
};

CornerNumbers numberCorners(const std::vector<Eigen::Vector3d>& points_mm);

/// Calls visit(first, last) for the sides of each edge.
template <class Visit>
void forEachEdge(std::span<const MeshEdge> edges, Visit visit)
{
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t j = i;
        while (j < edges.size() && edges[j].corners == edges[i].corners) ++j;
        visit(i, j);
        i = j;
    }
}

}  // namespace lathelier::registration
