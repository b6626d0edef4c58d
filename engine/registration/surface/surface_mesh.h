// Exact distance to a triangle mesh, with the sign from angle-weighted normals.
// Source: J. A. Bærentzen, H. Aanæs, "Signed distance computation using the angle weighted pseudonormal", IEEE TVCG 11
// (2005): the sign of the offset against the normal of the face, edge or corner that is nearest.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/registration/neighbours/neighbours_boxes.h"
#include "engine/registration/surface/mesh_edges.h"
#include "engine/registration/surface/surface.h"
#include "engine/registration/surface/triangle.h"

namespace lathelier::registration {

/// Corners with the same coordinates are one corner, as files without shared vertices (STL) need it; a mesh that is not
/// closed then is repaired (mesh_repair.h). Inside and outside: normals of the file, else the sense in which its facets
/// run round; a closed mesh whose volume is negative is taken as inside out.
class MeshSurface : public Surface {
public:
    MeshSurface(const Scan& mesh, const Progress& progress);

    void place(std::span<const Eigen::Vector3d> queries_mm, double max_distance_mm, std::span<SurfacePlace> places,
               std::span<Trace> traces) const override;
    bool orient(const Progress& progress) override;
    double scatter_mm() const override { return 0; }
    std::size_t pointCount() const override { return 0; }
    const Neighbours* points() const override { return nullptr; }
    double spacing_mm() const override { return 0; }
    Notes notes() const override { return notes_; }

private:
    static constexpr std::uint32_t leafSize = 4;

    struct Triangle {
        std::array<Eigen::Vector3d, 3> corners_mm;    ///< in the sense in which the facet runs round
        std::array<std::uint32_t, 3> corners;         ///< numbers in cornerNormals_
        std::array<Eigen::Vector3f, 3> edge_normals;  ///< of edge k: sum of the unit normals beside it
        std::uint8_t rim = 0;                         ///< bit k: edge k belongs to this triangle alone

        Eigen::Vector3d normal() const;
    };

    void build(const Scan& mesh, std::span<const TriangleCorners> triangles, const CornerNumbers& numbers,
               const Progress& progress);
    void connect(const Progress& progress);
    bool isNearlyClosed() const { return rim_mm_ * rim_mm_ < 0.05 * area_mm2_; }
    SurfacePlace placeOne(const Eigen::Vector3d& query_mm, double max_distance_mm, std::uint32_t& hint) const;

    std::vector<Triangle> triangles_;  ///< in the order of the tree's leaves
    std::vector<Eigen::Vector3d> cornerNormals_;
    std::vector<bool> cornerOnRim_;
    BoxTree boxes_;
    bool closed_ = false;        ///< every edge is passed as often in one sense as in the other
    std::size_t edges_ = 0;      ///< shared by two triangles
    std::size_t conflicts_ = 0;  ///< of them, where the two triangles run round in different senses
    double rim_mm_ = 0;          ///< length of the edges that belong to one triangle alone
    double rimMargin_mm_ = 0;    ///< a point further than this beyond a rim lies beside the surface
    double area_mm2_ = 0;
    double volume_mm3_ = 0;
    Notes notes_;
    double givenNormals_ = 0;  ///< agreement of the file's normals with the triangles; 0 without any
    double sense_ = 1;
};

}  // namespace lathelier::registration
