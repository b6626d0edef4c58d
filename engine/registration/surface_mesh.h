// Exact distance to a triangle mesh, with the sign from angle-weighted normals.
// Source: J. A. Bærentzen, H. Aanæs, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11
// (2005): the sign of the offset against the normal of the face, edge or corner that is nearest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/registration/neighbours_boxes.h"
#include "engine/registration/surface.h"
#include "engine/registration/triangle.h"

namespace lathelier {

/// Corners with the same coordinates are one corner, as files without shared vertices (STL) need it.
class MeshSurface : public Surface {
public:
    MeshSurface(const Scan& mesh, const Progress& progress);

    void place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm, std::span<SurfacePlace> places,
               std::span<std::uint32_t> hints) const override;
    bool orient(const Progress& progress) override;
    double scatter_mm() const override { return 0; }
    std::size_t pointCount() const override { return 0; }
    const Neighbours* points() const override { return nullptr; }
    double spacing_mm() const override { return 0; }

private:
    static constexpr std::uint32_t leaf_size = 4;

    struct Triangle {
        std::array<Eigen::Vector3d, 3> corners_mm;
        std::array<std::uint32_t, 3> corners;  ///< numbers in corner_normals_
        std::array<Eigen::Vector3f, 3> edge_normals;
        std::uint8_t rim = 0;  ///< bit k: edge k belongs to this triangle alone

        Eigen::Vector3d normal() const;
    };

    void connect(const Progress& progress);
    SurfacePlace placeOne(const Eigen::Vector3d& query_mm, double max_distance_mm, std::uint32_t& hint) const;

    std::vector<Triangle> triangles_;  ///< in the order of the tree's leaves
    std::vector<Eigen::Vector3d> corner_normals_;
    std::vector<bool> corner_on_rim_;
    BoxTree boxes_;
    bool closed_ = false;  ///< every edge is shared by two triangles with the same sense
    double volume_mm3_ = 0;
    double given_normals_ = 0;  ///< agreement of the file's normals with the triangles; 0 without any
    double sense_ = 1;
};

}  // namespace lathelier
