// The point of a triangle nearest to a point, and on which part of the triangle it lies.
// Source: C. Ericson, "Real-Time Collision Detection", 2005, section 5.1.5.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace lathelier::registration {

/// Corner k is corner k, edge k runs from corner k to corner k+1.
enum class TrianglePart : std::uint8_t { Corner0, Corner1, Corner2, Edge0, Edge1, Edge2, Face };

struct TrianglePoint {
    Eigen::Vector3d point_mm;  ///< the nearest point of the triangle
    TrianglePart part;         ///< where on the triangle it lies
};

/// Also for triangles without area.
TrianglePoint nearestOnTriangle(const Eigen::Vector3d& query_mm, const std::array<Eigen::Vector3d, 3>& corners_mm);

}  // namespace lathelier::registration
