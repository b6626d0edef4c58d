// A hole of a mesh closed by triangles between the corners of its rim.
// Source: P. Liepa, "Filling holes in meshes", Eurographics Symposium on Geometry Processing 2003 (the triangulation
// with the smallest largest dihedral angle, then area), as CGAL's Polygon_mesh_processing does it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace lathelier::registration {

/// Triangles (indices in `rim_mm`) that span the closed polygon `rim_mm` (3 to a few hundred different corners) and run
/// round it in its own sense. Empty where no triangulation is found. Cost n² to n³.
std::vector<std::array<std::uint32_t, 3>> fillHole(const std::vector<Eigen::Vector3d>& rim_mm);

}  // namespace lathelier::registration
