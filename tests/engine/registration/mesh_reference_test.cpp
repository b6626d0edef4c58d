// Meshes as they come: coarse, in several solids, with facets missing or turned.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/registration/compare.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/surface/mesh_repair.h"
#include "engine/registration/surface/surface_deviation.h"
#include "tests/engine/registration/cube_mesh.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

/// A shaft of flat facets, Ø50 × 850, `rings` rings of `sides` corners. The caps are solids of their own, their corners
/// written to six digits of a metre: not the wall's to the last bit.
Scan coarseShaft(int sides = 36, int rings = 41)
{
    Scan mesh;
    const auto corner = [&](int side, double z) {
        const double a = 2 * std::numbers::pi * side / sides;
        return Vector3d(25 * std::cos(a), 25 * std::sin(a), z);
    };
    const auto add = [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
        mesh.points_mm.insert(mesh.points_mm.end(), {a, b, c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    };
    for (int r = 0; r + 1 < rings; ++r)
        for (int s = 0; s < sides; ++s) {
            const double low = 50 + 850.0 * r / (rings - 1);
            const double high = 50 + 850.0 * (r + 1) / (rings - 1);
            add(corner(s, low), corner(s + 1, low), corner(s + 1, high));
            add(corner(s, low), corner(s + 1, high), corner(s, high));
        }
    const auto rounded = [](const Vector3d& p) { return Vector3d((p * 1e4).array().round() / 1e4); };
    for (int s = 0; s < sides; ++s) {
        add(rounded(corner(s + 1, 50)), rounded(corner(s, 50)), Vector3d(0, 0, 50));
        add(rounded(corner(s, 900)), rounded(corner(s + 1, 900)), Vector3d(0, 0, 900));
    }
    return mesh;
}

TEST(MeshReference, ComparedWithItselfDiffersNowhereByAnyMethod)
{
    const Scan mesh = coarseShaft();
    using M = CompareMethod;
    using S = Symmetry;
    for (const auto& [method, symmetry] :
         {std::pair{M::Revolution, S::Auto}, {M::Plane, S::Auto}, {M::Point, S::None}}) {
        CompareParameters parameters;
        parameters.method = method;
        parameters.symmetry = symmetry;
        const CompareResult result = compare(mesh, mesh, parameters);
        SCOPED_TRACE(testing::Message() << "method " << static_cast<int>(method) << ", symmetry "
                                        << static_cast<int>(symmetry));
        EXPECT_TRUE(result.has_sign);
        EXPECT_TRUE(result.alignment.converged);
        EXPECT_LT(result.statistics.rmse_mm, 1e-5);
        EXPECT_LT(std::abs(result.statistics.mean_mm), 1e-5);
        EXPECT_EQ(result.statistics.points_excluded, 0);
        EXPECT_EQ(contains(result.notes, notes::facetsCoarse), symmetry != S::None);
        for (const Note& note : result.notes)
            if (note.code == notes::facetsCoarse) {
                EXPECT_NEAR(std::get<double>(*find(note.values, "sagitta_mm")),
                            25 * (1 - std::cos(std::numbers::pi / 36)), 1e-6);
            }
    }
}

TEST(MeshReference, KeepsItsSignWithOneFacetMissing)
{
    Scan mesh = coarseShaft();
    mesh.triangles.erase(mesh.triangles.begin() + 1000);
    const double apothem = 25 * std::cos(std::numbers::pi / 36);
    const Vector3d out(std::cos(std::numbers::pi / 36), std::sin(std::numbers::pi / 36), 0);
    const SurfaceDeviation d = surfaceDeviation(
        mesh, {(apothem + 0.3) * out + Vector3d(0, 0, 400), (apothem - 0.2) * out + Vector3d(0, 0, 60), {0, 0, 900.1}},
        5);
    EXPECT_TRUE(d.has_sign);
    EXPECT_TRUE(contains(d.notes, notes::holesFilled));
    EXPECT_NEAR(d.deviation_mm[0], 0.3, 1e-5);
    EXPECT_NEAR(d.deviation_mm[1], -0.2, 1e-5);
    EXPECT_NEAR(d.deviation_mm[2], 0.1, 1e-5);
}

TEST(MeshReference, MeasuresOverAFilledHoleAsIfItWereWhole)
{
    const Scan whole = coarseShaft(90, 200);
    Scan mesh = whole;
    // Facets about one place of the wall: a hole of a few dozen edges.
    const Vector3d place(25, 0, 300);
    std::erase_if(mesh.triangles, [&](const auto& t) {
        return (mesh.points_mm[t[0]] + mesh.points_mm[t[1]] + mesh.points_mm[t[2]] - 3 * place).norm() < 3 * 8;
    });
    ASSERT_LT(mesh.triangles.size() + 30, whole.triangles.size());
    std::vector<Vector3d> queries;
    for (int i = -6; i <= 6; ++i) queries.push_back(place + Vector3d(0.5, i, i));
    const SurfaceDeviation filled = surfaceDeviation(mesh, queries, 5);
    const SurfaceDeviation truth = surfaceDeviation(whole, queries, 5);
    EXPECT_TRUE(contains(filled.notes, notes::holesFilled));
    // The patch is flat across the hole: it lies inside the round wall by up to its sagitta, not more.
    for (std::size_t i = 0; i < queries.size(); ++i) EXPECT_NEAR(filled.deviation_mm[i], truth.deviation_mm[i], 1.3);
    EXPECT_TRUE(filled.has_sign);
    EXPECT_GT(filled.deviation_mm[6], 0);
}

TEST(MeshReference, SaysNothingBesideAnOpeningThatMayBeMeant)
{
    Scan tube = coarseShaft();
    std::erase_if(tube.triangles, [&](const auto& t) {  // without its upper cap
        return tube.points_mm[t[0]].z() > 899 && tube.points_mm[t[1]].z() > 899 && tube.points_mm[t[2]].z() > 899;
    });
    const SurfaceDeviation d =
        surfaceDeviation(tube, {{10, 3, 901}, {25.4, 0, 899.99}, {24.5, 0, 500}, {0, 0, 49}}, 50);
    EXPECT_TRUE(d.has_sign);
    EXPECT_FALSE(contains(d.notes, notes::holesFilled));
    EXPECT_TRUE(std::isnan(d.deviation_mm[0])) << "the rim is 14 mm away, but where the cap was nothing is known";
    EXPECT_NEAR(d.deviation_mm[1], 0.4, 0.01);
    EXPECT_LT(d.deviation_mm[2], 0);
    EXPECT_NEAR(d.deviation_mm[3], 1, 1e-6);
}

TEST(MeshReference, TurnsFacetsThatRunRoundTheOtherWay)
{
    Scan mesh = cube(10);
    for (const std::size_t t : {1U, 4U, 7U}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    const SurfaceDeviation d = surfaceDeviation(mesh, {{5, 5, 12}, {5, 5, 9}, {12, 12, 12}, {5, -1, 3}}, 100);
    EXPECT_TRUE(d.has_sign);
    EXPECT_TRUE(contains(d.notes, notes::facetsTurned));
    EXPECT_FLOAT_EQ(d.deviation_mm[0], 2);
    EXPECT_FLOAT_EQ(d.deviation_mm[1], -1);
    EXPECT_FLOAT_EQ(d.deviation_mm[2], static_cast<float>(std::sqrt(12.0)));
    EXPECT_FLOAT_EQ(d.deviation_mm[3], 1);
}

TEST(MeshReference, WithoutTwoSidesHasNoSign)
{
    Scan band;  // Möbius
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) {
        const double a = 2 * std::numbers::pi * i / count;
        const Vector3d out(std::cos(a), std::sin(a), 0);
        const Vector3d across = std::cos(a / 2) * Vector3d::UnitZ() + std::sin(a / 2) * out;
        band.points_mm.push_back(30 * out - 5 * across);
        band.points_mm.push_back(30 * out + 5 * across);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const bool last = i + 1 == count;
        const std::uint32_t a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        band.triangles.push_back({a, c, b});
        band.triangles.push_back({b, c, d});
    }
    EXPECT_FALSE(surfaceDeviation(band, {{30, 1, 0}}, 100).has_sign);
}

TEST(MeshRepair, LeavesAnIslandOpen)
{
    Scan mesh = coarseShaft();
    const auto first = static_cast<std::uint32_t>(mesh.points_mm.size());
    for (const Vector3d& p : {Vector3d(60, 0, 100), Vector3d(66, 0, 100), Vector3d(66, 5, 100), Vector3d(60, 5, 100)})
        mesh.points_mm.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    const RepairedMesh repaired = repairMesh(mesh);
    EXPECT_EQ(repaired.holes_filled, 0);
    EXPECT_EQ(repaired.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(repaired.facets_turned, 0);
}

TEST(MeshRepair, StitchesCornersThatRoundingHasSplit)
{
    const Scan mesh = coarseShaft();
    const RepairedMesh repaired = repairMesh(mesh);
    std::vector<TriangleCorners> numbered;
    for (const TriangleCorners& t : repaired.triangles) numbered.push_back(repaired.corners.of(t));
    const std::vector<MeshEdge> edges = edgesOf(numbered);
    std::size_t open = 0;
    forEachEdge(edges, [&](std::size_t first, std::size_t last) { open += last - first == 1; });
    EXPECT_EQ(open, 0U);
    EXPECT_EQ(repaired.holes_filled, 0);
}

}  // namespace
}  // namespace lathelier::registration
