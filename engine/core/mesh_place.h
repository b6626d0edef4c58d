// A place on a mesh.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace lathelier {

/// The corners of a triangle and their weights, which add up to 1.
struct MeshPlace {
    std::array<std::uint32_t, 3> corners{};             ///< indices of the vertices
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< one for each corner
};

}  // namespace lathelier
