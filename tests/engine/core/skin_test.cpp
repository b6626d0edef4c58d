// The skin of a body of revolution: closed whatever its error is magnified by, and displaced where the error is.
#include "engine/core/skin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "tests/mesh_volume.h"

namespace lathelier {
namespace {

/// Two steps, Ø20 × 30 and Ø30 × 20.
Skin steps(double step_mm = 1, int angles = 120)
{
    Skin skin;
    skin.stations = stationsAlong({{0, 0}, {0, 10}, {30, 10}, {30, 15}, {50, 15}, {50, 0}}, step_mm);
    skin.angle_count = angles;
    skin.values.assign(skin.vertexCount(), std::numeric_limits<float>::quiet_NaN());
    return skin;
}

/// Sets the values of sides (or faces) with these places along the axis.
void setValues(Skin& skin, bool faces, double from_mm, double to_mm, float value)
{
    for (std::size_t i = 0; i < skin.values.size(); ++i) {
        const SkinStation& station = skin.stations[i / static_cast<std::size_t>(skin.angle_count)];
        if (station.isFace() == faces && station.z_mm >= from_mm && station.z_mm <= to_mm) skin.values[i] = value;
    }
}

/// Every edge between two places occurs once in each direction.
bool isClosed(const Scan& mesh)
{
    const auto rounded = [&mesh](std::uint32_t corner) {
        const Eigen::Vector3d p = mesh.points_mm[corner] * 1e4;
        return std::make_tuple(std::lround(p.x()), std::lround(p.y()), std::lround(p.z()));
    };
    std::map<std::pair<std::tuple<long, long, long>, std::tuple<long, long, long>>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = rounded(t[k]), b = rounded(t[(k + 1) % 3]);
            if (a == b) continue;
            ++edges[{a, b}];
            --edges[{b, a}];
        }
    return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

/// Of a regular polygon of so many corners, as a share of its circle's.
double polygonShare(int corners)
{
    return corners / (2 * M_PI) * std::sin(2 * M_PI / corners);
}

TEST(Skin, IsClosedAndHasTheVolumeOfThePart)
{
    const Skin skin = steps();
    const Scan mesh = meshOf(skin, 1, Eigen::Isometry3d::Identity());
    EXPECT_TRUE(isClosed(mesh));
    const double volume = M_PI * (100.0 * 30 + 225.0 * 20) * polygonShare(skin.angle_count);
    EXPECT_NEAR(volumeOf(mesh), volume, 1e-9 * volume);
    ASSERT_EQ(mesh.points_mm.size(), skin.vertexCount());
    ASSERT_TRUE(mesh.hasNormals());
}

TEST(Skin, AnEdgeHasAStationOnEachOfItsSides)
{
    int edges = 0;
    const Skin skin = steps();
    for (std::size_t i = 1; i < skin.stations.size(); ++i) {
        const SkinStation &a = skin.stations[i - 1], &b = skin.stations[i];
        if (a.z_mm == b.z_mm && a.radius_mm == b.radius_mm) {
            EXPECT_NE(a.isFace(), b.isFace());
            ++edges;
        }
    }
    EXPECT_EQ(edges, 4);
}

TEST(Skin, SidesMoveAcrossTheAxisAndFacesAlongIt)
{
    Skin skin = steps();
    setValues(skin, false, 0, 29.9, 0.01F);    // the smaller step, larger by 0.01
    setValues(skin, false, 30.1, 50, -0.02F);  // the larger one, smaller
    setValues(skin, true, 49, 51, 0.05F);      // the part is longer
    setValues(skin, true, 0, 0, 0);
    skin.shift_mm = normalShift_mm(skin);
    constexpr double factor = 50;
    const Scan mesh = meshOf(skin, factor, Eigen::Isometry3d::Identity());
    EXPECT_TRUE(isClosed(mesh));
    double largest_mm = 0, last_mm = 0, small_mm = 0;
    for (const Eigen::Vector3d& p : mesh.points_mm) {
        if (p.z() > 40) largest_mm = std::max(largest_mm, p.head<2>().norm());
        last_mm = std::max(last_mm, p.z());
        if (p.z() < 20) small_mm = std::max(small_mm, p.head<2>().norm());
    }
    EXPECT_NEAR(largest_mm, 15 - factor * 0.02, 1e-4);
    EXPECT_NEAR(small_mm, 10 + factor * 0.01, 1e-4);
    EXPECT_NEAR(last_mm, 50 + factor * 0.05, 1e-4);
}

/// One place is off by 0.1 mm and another is unknown: nothing tears at any magnification.
TEST(Skin, StaysClosedWithHolesInTheDataAtAnyMagnification)
{
    Skin skin = steps();
    setValues(skin, false, 0, 50, 0);
    for (std::size_t i = 0; i < skin.values.size(); i += 7) skin.values[i] = i % 2 == 0 ? 0.1F : NAN;
    setValues(skin, false, 12, 18, NAN);
    skin.shift_mm = normalShift_mm(skin);
    for (const double factor : {1.0, 20.0, 90.0})
        EXPECT_TRUE(isClosed(meshOf(skin, factor, Eigen::Isometry3d::Identity()))) << factor;
    for (const Eigen::Vector3f& shift : skin.shift_mm) EXPECT_TRUE(shift.allFinite());
}

TEST(Skin, APlaceIsFoundAgain)
{
    const Skin skin = steps();
    const Eigen::Isometry3d pose =
        Eigen::Translation3d(3, 4, 5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 1, 0).normalized());
    const Scan mesh = meshOf(skin, 1, pose);
    const auto& corners = mesh.triangles[mesh.triangles.size() / 2];
    const MeshPlace place{corners, Eigen::Vector3d(0.2, 0.3, 0.5)};
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        expected += place.weights[static_cast<Eigen::Index>(i)] * (pose.inverse() * mesh.points_mm[corners[i]]);
    EXPECT_LT((placeOn(skin, place) - expected).norm(), 1e-9);
    for (const std::size_t vertex : {std::size_t{500}, skin.vertexCount() / 2}) {
        const Eigen::Vector3d there = vertexOf(skin, vertex, 0);
        EXPECT_LT((vertexOf(skin, nearestVertex(skin, there), 0) - there).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace lathelier
