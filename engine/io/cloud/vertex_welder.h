// Equal corners of separate triangles as shared vertices.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace lathelier::io {

/// Assigns equal indices to equal coordinates, in the order of first appearance. -0 equals 0; NaN equals nothing.
class VertexWelder {
public:
    explicit VertexWelder(std::vector<Eigen::Vector3d>& vertices);

    /// The index of `corner` in the vertices, where it is added when it is new.
    std::uint32_t indexOf(const Eigen::Vector3d& corner);

private:
    void grow();

    std::vector<Eigen::Vector3d>& vertices_;
    std::vector<std::uint32_t> slots_;  ///< open addressing; index + 1, 0 when free
};

}  // namespace lathelier::io
