// The nearest point of a triangle, with and without area.
#include "engine/registration/surface/triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/core/random.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

TEST(Triangle, EveryPartIsFound)
{
    const Corners corners{Vector3d(0, 0, 0), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};
    struct Case {
        Vector3d query;
        Vector3d nearest;
        TrianglePart part;
    };
    for (const Case& c : std::vector<Case>{{{-1, -1, 2}, {0, 0, 0}, TrianglePart::Corner0},
                                           {{6, -1, 2}, {4, 0, 0}, TrianglePart::Corner1},
                                           {{-1, 6, 2}, {0, 4, 0}, TrianglePart::Corner2},
                                           {{2, -1, 2}, {2, 0, 0}, TrianglePart::Edge0},
                                           {{4, 4, 2}, {2, 2, 0}, TrianglePart::Edge1},
                                           {{-1, 2, 2}, {0, 2, 0}, TrianglePart::Edge2},
                                           {{1, 1, 2}, {1, 1, 0}, TrianglePart::Face}}) {
        const TrianglePoint found = nearestOnTriangle(c.query, corners);
        EXPECT_LT((found.point_mm - c.nearest).norm(), 1e-15);
        EXPECT_EQ(found.part, c.part);
    }
}

/// Of a triangle whose corners lie on a line the nearest point is that of the longest edge.
TEST(Triangle, WithoutAreaTheNearestEdgeCounts)
{
    for (std::uint64_t i = 0; i < 200; ++i) {
        const auto number = [&](std::uint64_t k) { return 10 * randomUniform(5, i, k) - 5; };
        const Vector3d from(number(0), number(1), number(2));
        const Vector3d along(number(3), number(4), number(5));
        const Corners corners{from, from + 0.25 * along, from + along};
        const Vector3d query(number(6), number(7), number(8));
        const double t = std::clamp((query - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const TrianglePoint found = nearestOnTriangle(query, corners);
        EXPECT_NEAR((found.point_mm - query).norm(), (from + t * along - query).norm(), 1e-9);
        EXPECT_NE(found.part, TrianglePart::Face);
    }
    const Corners point{Vector3d(1, 2, 3), Vector3d(1, 2, 3), Vector3d(1, 2, 3)};
    EXPECT_EQ(nearestOnTriangle(Vector3d(5, 5, 5), point).point_mm, Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace lathelier::registration
