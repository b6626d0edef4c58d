// The mesh of a shaft: closed, with its volume, within its sagitta.
#include "engine/features/comparison/shaft_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"
#include "made_recognition.h"
#include "tests/mesh_volume.h"

namespace lathelier::features {
namespace {

Shaft shaftOf(const Table& table)
{
    Shaft shaft;
    for (const TableRow& row : table)
        shaft.segments.push_back({row.length_mm, row.start_mm, row.end_mm, 0, row.arc_mm, {}});
    return shaft;
}

/// Every edge belongs to two triangles, which run along it in opposite senses.
void expectClosed(const Scan& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_TRUE(edges.count({edge.second, edge.first}));
    }
}

TEST(ShaftMesh, StraightMeridiansHaveTheirVolume)
{
    const Shaft shaft = shaftOf(tableOne());
    const ShaftMesh made = shaftMesh(shaft);
    EXPECT_EQ(made.sagitta_mm, meshingLimits.finest_sagitta_mm);
    EXPECT_NEAR(volumeOf(made.scan), 146123.0665, 1e-4);
    expectClosed(made.scan);
}

TEST(ShaftMesh, ArcsAndUndercuts)
{
    for (const Table& table : {undercutPart(), taperPart()}) {
        const Shaft shaft = shaftOf(table);
        checkShaft(shaft);
        const double exact = volume_mm3(shaft);
        for (const double sagitta_mm : {2e-2, 2e-3, 2e-4}) {
            const ShaftMesh made = shaftMesh(shaft, sagitta_mm);
            EXPECT_LT(std::abs(volumeOf(made.scan) - exact), 200 * std::pow(sagitta_mm, 1.5)) << sagitta_mm;
            expectClosed(made.scan);
        }
    }
}

TEST(ShaftMesh, BoresAreOpenInside)
{
    Shaft shaft = shaftOf(cylinder(40, 30) + cylinder(60, 10));
    shaft.bores = {{ShaftEnd::Free, {{12, 20, 20, {}, {}}, {3, 20, 8, {}, {}}}},
                   {ShaftEnd::Chuck, {{10, 30, 28, {}, {}}}}};
    const ShaftMesh blind = shaftMesh(shaft);
    EXPECT_NEAR(volumeOf(blind.scan), volume_mm3(shaft), 1e-4);
    expectClosed(blind.scan);
    shaft.bores = {{ShaftEnd::Chuck, {{40, 10, 12, {}, {}}}}};
    const ShaftMesh through = shaftMesh(shaft);
    EXPECT_NEAR(volumeOf(through.scan), volume_mm3(shaft), 1e-4);
    expectClosed(through.scan);
}

TEST(ShaftMesh, BallEnd)
{
    const Shaft shaft = shaftOf(Table{{10, 0, 20, 10.0}} + cylinder(20, 30));
    const ShaftMesh made = shaftMesh(shaft);
    EXPECT_NEAR(volumeOf(made.scan), std::numbers::pi * (2.0 / 3 * 1000 + 3000), 1e-3);
    expectClosed(made.scan);
    for (const Eigen::Vector3d& point : made.scan.points_mm) {
        if (point.z() > 10) continue;
        EXPECT_NEAR((point - Eigen::Vector3d(0, 0, 10)).norm(), 10, 4e-4);
    }
}

TEST(ShaftMesh, CoarserWhereThereWouldBeTooMany)
{
    Table table;
    for (int i = 0; i < 60; ++i) table = table + filletUp(300, 4) + filletDown(300, 4);
    const ShaftMesh made = shaftMesh(shaftOf(table), 1e-5);
    EXPECT_LE(made.scan.triangles.size(), meshingLimits.most_triangles);
    EXPECT_GT(made.scan.triangles.size(), meshingLimits.most_triangles / 4);
    EXPECT_GT(made.sagitta_mm, 1e-5);
}

}  // namespace
}  // namespace lathelier::features
