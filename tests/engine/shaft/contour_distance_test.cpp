// Distances from a meridian against brute force and by hand.
#include "engine/shaft/contour_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "tests/engine/shaft/shaft_row.h"

namespace lathelier {
namespace {

using Eigen::Vector2d;

/// Round, cylinder, fillet, shoulder, cone, chamfer, and a stepped bore from the chuck.
Shaft rich()
{
    Shaft shaft;
    shaft.segments = {shaftRow(2, 16, 20, 2), shaftRow(30, 20, 20), shaftRow(1, 20, 22, -1), shaftRow(20, 40, 40),
                      shaftRow(25, 40, 30),   shaftRow(9, 30, 30),  shaftRow(1, 30, 28)};
    shaft.bores = {{ShaftEnd::Chuck, {{12, 16, 16, {}, {}}, {8, 10, 10, {}, {}}}}};
    return shaft;
}

/// Points along all pieces that are surface.
std::vector<Vector2d> dense(const Contour& contour)
{
    std::vector<Vector2d> points;
    for (const ContourPiece& piece : contour) {
        if (std::max(piece.from_mm.y(), piece.to_mm.y()) < 1e-9) continue;
        constexpr int count = 20000;
        for (int i = 0; i <= count; ++i) {
            const double t = static_cast<double>(i) / count;
            if (!piece.isArc()) {
                points.push_back(piece.from_mm + t * (piece.to_mm - piece.from_mm));
                continue;
            }
            const auto [start, end] = piece.arcAngles();
            const double angle = start + t * (end - start);
            points.push_back(piece.centre_mm() +
                             std::abs(piece.arc_radius_mm) * Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    return points;
}

/// Crossings of a ray toward larger r with the contour, as its dense points have them.
bool isInside(const Contour& contour, const std::vector<Vector2d>& points, const Vector2d& at)
{
    int crossings = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vector2d &a = points[i], &b = points[i + 1];
        if ((b - a).norm() > 0.1 || (a.x() > at.x()) == (b.x() > at.x())) continue;
        crossings += a.y() + (b.y() - a.y()) * (at.x() - a.x()) / (b.x() - a.x()) > at.y();
    }
    return contour.empty() ? false : crossings % 2 == 1;
}

TEST(ContourDistance, ByHand)
{
    Shaft shaft;
    shaft.segments = {shaftRow(10, 20, 20), shaftRow(10, 30, 30)};
    const ContourDistance distance(closedContour(shaft), 5);
    EXPECT_NEAR(distance.footOf(5, 10.25)->distance_mm, 0.25, 1e-15);
    EXPECT_NEAR(distance.footOf(5, 9.9)->distance_mm, -0.1, 1e-14);
    EXPECT_NEAR(distance.footOf(9.7, 12)->distance_mm, 0.3, 1e-14);                      // before the shoulder
    EXPECT_NEAR(distance.footOf(10 - 0.3, 15.4)->distance_mm, 0.5, 1e-14);               // over its edge
    EXPECT_NEAR(distance.footOf(10.1, 9.8)->distance_mm, -std::hypot(0.1, 0.2), 1e-14);  // within its corner
    EXPECT_NEAR(distance.footOf(-0.2, 0)->distance_mm, 0.2, 1e-15);                      // at the axis
    EXPECT_NEAR(distance.footOf(20.5, 3)->outward.x(), 1, 1e-15);
    EXPECT_FALSE(distance.footOf(5, 15.1));  // out of reach
    EXPECT_FALSE(distance.footOf(30, 3));
    EXPECT_FALSE(distance.footOf(std::numeric_limits<double>::quiet_NaN(), 3));
}

TEST(ContourDistance, AgainstBruteForce)
{
    const Contour contour = closedContour(rich());
    const ContourDistance distance(contour, 4);
    const std::vector<Vector2d> points = dense(contour);
    int near = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        const Vector2d at(-3 + 94 * randomUniform(5, 1, i), 23 * randomUniform(5, 2, i));
        double nearest = 1e300;
        for (const Vector2d& point : points) nearest = std::min(nearest, (point - at).norm());
        const auto foot = distance.footOf(at.x(), at.y());
        ASSERT_EQ(foot.has_value(), nearest < 4) << at.transpose();
        if (!foot) continue;
        ++near;
        EXPECT_NEAR(std::abs(foot->distance_mm), nearest, 1e-4) << at.transpose();
        if (nearest > 0.01) {
            EXPECT_EQ(foot->distance_mm < 0, isInside(contour, points, at)) << at.transpose();
        }
        EXPECT_NEAR(foot->outward.norm(), 1, 1e-12);
        const auto on = distance.footOf(at.x() - foot->distance_mm * foot->outward.x(),
                                        std::abs(at.y() - foot->distance_mm * foot->outward.y()));
        EXPECT_LT(std::abs(on.value().distance_mm), 1e-9) << at.transpose();
    }
    EXPECT_GT(near, 120);
}

}  // namespace
}  // namespace lathelier
