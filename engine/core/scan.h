// A scanned or designed surface: points, with normals and triangles when the source has them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace lathelier {

/// Points of a surface in mm, in the order of the file, all finite. A mesh shares its vertices: `points_mm` are the
/// vertices and `triangles` their indices, anticlockwise seen from outside the material.
struct Scan {
    std::vector<Eigen::Vector3d> points_mm;
    std::vector<Eigen::Vector3f> normals;  ///< empty, or one unit vector for each point, out of the material
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< empty for a cloud

    bool isMesh() const { return !triangles.empty(); }
    bool hasNormals() const { return !normals.empty(); }
};

using ScanPtr = std::shared_ptr<const Scan>;

}  // namespace lathelier
