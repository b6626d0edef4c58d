// A comparison with the exact meridian of a drawing beside that with its finest mesh.
#include "engine/registration/drawn_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/features/shaft_mesh.h"
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

}  // namespace
}  // namespace lathelier::features
