// Free-form surfaces that are exactly planes, cylinders, cones, spheres or tori, found by points and normals.
#include "engine/cad/canonical_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>

namespace lathelier::cad {
namespace {

using Eigen::Vector3d;

/// Part of a surface of revolution: the meridian (z, r) with its normal at v, about a tilted axis, over `turn`.
std::vector<SurfaceSpot> patch(const std::function<std::array<double, 4>(double)>& meridian, double turn,
                               const Eigen::Isometry3d& pose)
{
    std::vector<SurfaceSpot> spots;
    for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j) {
            const auto [z, r, nz, nr] = meridian(i / 8.0);
            const double angle = 0.3 + turn * j / 8.0;
            const Vector3d out(std::cos(angle), std::sin(angle), 0);
            spots.push_back({pose * Vector3d(r * out + z * Vector3d::UnitZ()),
                             (pose.linear() * (nr * out + nz * Vector3d::UnitZ())).normalized()});
        }
    return spots;
}

const Eigen::Isometry3d tilted = Eigen::Translation3d(40, -25, 310) *
                                 Eigen::AngleAxisd(0.7, Vector3d(1, 2, 0.5).normalized()) *
                                 Eigen::Isometry3d::Identity();

void expectAxis(const CanonicalSurface& found)
{
    const Vector3d axis = tilted.linear().col(2);
    EXPECT_LT(found.axis.cross(axis).norm(), 1e-7);
    const Vector3d off = found.axis_point_mm - tilted.translation();
    EXPECT_LT((off - off.dot(axis) * axis).norm(), 1e-5);
}

TEST(CanonicalSurface, FindsEachKind)
{
    for (const double turn : {1.0, 3.1, 6.2}) {
        const auto cylinder = patch([](double v) { return std::array{30 * v, 15.0, 0.0, 1.0}; }, turn, tilted);
        auto found = canonicalSurface(cylinder, cylinder[40].point_mm);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->kind, SurfaceKind::Cylinder);
        EXPECT_NEAR(found->radius_mm, 15, 1e-6);
        expectAxis(*found);

        const auto cone = patch([](double v) { return std::array{v, 15 - v, 1.0, 1.0}; }, turn, tilted);
        found = canonicalSurface(cone, cone[40].point_mm);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->kind, SurfaceKind::Cone);
        expectAxis(*found);

        const auto plane = patch([](double v) { return std::array{7.0, 5 + 10 * v, 1.0, 0.0}; }, turn, tilted);
        found = canonicalSurface(plane, plane[40].point_mm);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->kind, SurfaceKind::Plane);
        EXPECT_LT(found->axis.cross(tilted.linear().col(2)).norm(), 1e-7);

        const auto sphere = patch(
            [](double v) {
                return std::array{20 * std::sin(v), 20 * std::cos(v), std::sin(v), std::cos(v)};
            },
            turn, tilted);
        found = canonicalSurface(sphere, sphere[40].point_mm);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->kind, SurfaceKind::Sphere);
        EXPECT_NEAR(found->radius_mm, 20, 1e-5);
        EXPECT_LT((found->axis_point_mm - tilted.translation()).norm(), 1e-5);

        const auto fillet = patch(
            [](double v) {
                return std::array{2 * std::sin(v), 12 + 2 * std::cos(v), std::sin(v), std::cos(v)};
            },
            turn, tilted);
        found = canonicalSurface(fillet, fillet[40].point_mm);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->kind, SurfaceKind::RevolvedArc);
        EXPECT_NEAR(found->radius_mm, 2, 1e-5);
        expectAxis(*found);
        const Vector3d centre = tilted.inverse() * found->circle_centre_mm;
        EXPECT_NEAR(centre.z(), 0, 1e-4);
        EXPECT_NEAR(centre.head<2>().norm(), 12, 1e-4);
    }
}

TEST(CanonicalSurface, OtherSurfacesAreNone)
{
    // A parabola revolved, and a cylinder with 1 µm of ovality.
    const auto parabola = patch([](double v) { return std::array{10 * v, 12 + 3 * v * v, -0.6 * v, 1.0}; }, 3, tilted);
    EXPECT_FALSE(canonicalSurface(parabola, parabola[40].point_mm));
    auto oval = patch([](double v) { return std::array{30 * v, 15.0, 0.0, 1.0}; }, 6.2, tilted);
    for (std::size_t i = 0; i < oval.size(); ++i)
        oval[i].point_mm += 1e-3 * std::cos(2 * 6.2 * static_cast<double>(i % 9) / 8) * oval[i].normal;
    EXPECT_FALSE(canonicalSurface(oval, oval[40].point_mm));
    EXPECT_FALSE(canonicalSurface({}, Vector3d::Zero()));
}

}  // namespace
}  // namespace lathelier::cad
