// A comparison with the exact meridian of a drawing beside that with its finest mesh.
#include "engine/registration/drawn_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/core/random.h"
#include "engine/features/comparison/shaft_mesh.h"
#include "engine/registration/surface/drawn_surface.h"
#include "made_scan.h"

namespace lathelier::features {
namespace {

ShaftSegment row(double length, double start, double end, std::optional<double> arc = {})
{
    ShaftSegment made;
    made.length_mm = length;
    made.start_diameter_mm = start;
    made.end_diameter_mm = end;
    made.arc_radius_mm = arc;
    return made;
}

/// The part of made_scan.h as a table.
Shaft featureShaft()
{
    Shaft shaft;
    shaft.segments = {row(1, 14, 16, 1), row(19, 16, 16), row(0.8, 16, 17.6, -0.8), row(14.2, 24, 24), row(40, 24, 28),
                      row(10, 28, 28),   row(10, 42, 42), row(2, 38, 38),           row(9, 42, 42),    row(1, 42, 40)};
    return shaft;
}

TEST(DrawnReference, AgreesWithTheFinestMesh)
{
    sample::ScannerModel scanner = askew(4);
    scanner.row_pitch_mm = 0.2;
    const Scan copy = sample::scanShaft(featurePart(), scanner);
    const Shaft shaft = featureShaft();
    const registration::DrawnReference drawn{shaftMesh(shaft).scan, closedContour(shaft)};
    registration::CompareParameters parameters;
    parameters.tolerance_mm = 0.2;
    const registration::CompareResult mesh = registration::compare(drawn.mesh, copy, parameters),
                                      exact = registration::compare(drawn, copy, parameters);
    EXPECT_NEAR(exact.statistics.rmse_mm, mesh.statistics.rmse_mm, 1e-3);
    EXPECT_NEAR(exact.statistics.mean_mm, mesh.statistics.mean_mm, 1e-3);
    EXPECT_EQ(exact.verdict, mesh.verdict);
    ASSERT_EQ(exact.deviation_mm.size(), mesh.deviation_mm.size());
    std::size_t both = 0, far = 0;
    for (std::size_t i = 0; i < exact.deviation_mm.size(); ++i) {
        const auto a = static_cast<double>(exact.deviation_mm[i]), b = static_cast<double>(mesh.deviation_mm[i]);
        if (std::isnan(a) || std::isnan(b)) continue;
        ++both;
        far += std::abs(a - b) > 1e-3;
    }
    EXPECT_GT(both, copy.points_mm.size() * 99 / 100);
    EXPECT_LT(far, both / 10000);  // at edges a facet's corner may turn the sign
    EXPECT_TRUE(exact.has_sign);
}

TEST(DrawnReference, KnownOversize)
{
    // Every diameter 40 µm over: 20 µm everywhere on the sides.
    sample::ShaftModel over = sample::nominalShaft();
    for (sample::ShaftPiece& piece : over) piece.oversize_um = 20;
    const Scan copy = sample::scanShaft(over, askew(6));
    Shaft shaft;
    shaft.segments = {row(98, 30, 30), row(10, 37, 37), row(70, 33.8, 33.8), row(5, 33.8, 23.8)};
    const auto result =
        registration::compare(registration::DrawnReference{shaftMesh(shaft).scan, closedContour(shaft)}, copy);
    EXPECT_NEAR(result.statistics.median_mm, 0.020, 1e-3);
    EXPECT_NEAR(result.statistics.mad_sigma_mm, 0.05, 2e-3);
}

/// The exact surface of the alignment beside the triangles: the distance differs by less than their sagitta.
TEST(DrawnReference, SurfaceIsThatOfItsMesh)
{
    const Shaft shaft = featureShaft();
    const ShaftMesh mesh = shaftMesh(shaft);
    const Eigen::Vector3d middle(3, -2, 40);
    Scan shifted = mesh.scan;
    for (Eigen::Vector3d& point : shifted.points_mm) point -= middle;
    const auto triangles = registration::makeSurface(shifted, {});
    ASSERT_TRUE(triangles->orient({}));
    const registration::DrawnSurface drawn(closedContour(shaft), middle);
    std::vector<Eigen::Vector3d> queries;
    for (std::uint64_t i = 0; i < 2000; ++i)
        queries.push_back(Eigen::Vector3d(30 * (randomUniform(1, 0, i) - 0.5), 30 * (randomUniform(1, 1, i) - 0.5),
                                          130 * randomUniform(1, 2, i) - 10) -
                          middle);
    constexpr double reach_mm = 4;
    std::vector<registration::SurfacePlace> exact(queries.size()), meshed(queries.size());
    drawn.place(queries, reach_mm, exact, {});
    triangles->place(queries, reach_mm, meshed, {});
    std::size_t both = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        if (std::abs(exact[i].distance_mm) > reach_mm - 1e-3 || !exact[i].found()) continue;
        ASSERT_TRUE(meshed[i].found()) << i;
        ++both;
        EXPECT_NEAR(exact[i].distance_mm, meshed[i].distance_mm, 2 * mesh.sagitta_mm) << queries[i].transpose();
        EXPECT_NEAR(exact[i].normal.norm(), 1, 1e-12);
    }
    EXPECT_GT(both, 300U);
    EXPECT_LT(both, queries.size());
}

/// The work for a cone follows its rows and not its size (tests/bench): with triangles this took minutes.
TEST(DrawnReference, HugeConeIsAligned)
{
    Shaft shaft;
    shaft.segments = {row(98, 30, 30000), row(10, 37, 37)};
    const Scan copy = sample::scanShaft(sample::nominalShaft(), askew(6));
    registration::CompareParameters parameters;
    parameters.method = registration::CompareMethod::Plane;
    try {
        registration::compare(registration::DrawnReference{shaftMesh(shaft).scan, closedContour(shaft)}, copy,
                              parameters);
    } catch (const Error& error) {
        EXPECT_STREQ(error.code().key, "parts_do_not_match");
    }
}

}  // namespace
}  // namespace lathelier::features
