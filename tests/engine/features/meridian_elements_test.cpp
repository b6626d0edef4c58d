// Balls at the ends, arcs of large radius, steep flanks: scans of parts whose sizes are known in closed form.
#include <gtest/gtest.h>

#include <numbers>

#include "engine/core/random.h"
#include "engine/features/features_codes.h"
#include "engine/features/walls/segmentation.h"
#include "engine/features/walls/steep_walls.h"
#include "made_scan.h"

namespace lathelier::features {
namespace {

/// A ball of radius R from the angle `from` about its centre to `to`, both from its pole, as short cones of equal
/// angle; the pole lies at z = 0.
sample::ShaftModel ballPart(double R, double from, double to)
{
    constexpr int count = 90;
    const double zero = R * (1 - std::cos(from));
    sample::ShaftModel shaft;
    for (int i = 0; i < count; ++i) {
        const double a = from + (to - from) * i / count, b = from + (to - from) * (i + 1) / count;
        shaft.push_back(piece(R * (1 - std::cos(a)) - zero, R * (1 - std::cos(b)) - zero, 2 * R * std::sin(a),
                              2 * R * std::sin(b)));
    }
    const double z = shaft.back().z_end_mm;
    shaft.push_back(piece(z, z + 25, 12, 12));
    shaft.push_back(piece(z + 25, z + 40, 18, 18));
    shaft.push_back(piece(z + 40, z + 41, 18, 16));
    return shaft;
}

sample::ScannerModel quiet(std::uint64_t seed, double pitch_mm = 0.1)
{
    sample::ScannerModel scanner = askew(seed, 0.02);
    scanner.row_pitch_mm = pitch_mm;
    scanner.angle_step_deg = 1.5;
    return scanner;
}

TEST(BallEnd, IsClosedAtItsPole)
{
    // Beyond its equator to a neck of ⌀12: 18 mm of the ball, then 41 mm.
    const Recognition found = recognize(scanShaft(ballPart(10, 0, std::numbers::pi - std::asin(0.6)), quiet(5)), {});
    ASSERT_EQ(found.segments.size(), 4U);
    EXPECT_NEAR(found.length_mm.value(), 59, 0.02);
    ASSERT_EQ(found.marks.size(), 1U);
    const ShaftMark& ball = found.marks[0];
    EXPECT_EQ(ball.kind, MarkKind::Sphere);
    EXPECT_LT(ball.uncertainty_mm.value(), 0.005);
    EXPECT_NEAR(ball.diameter_mm.value(), 20, ball.uncertainty_mm.value() + 0.001);
    EXPECT_NEAR(ball.z_end_mm.value(), 18, 0.01);
    EXPECT_EQ(found.segments[0].start_diameter_mm, 0);
    EXPECT_EQ(found.ends[0].closed_by, "round");
    EXPECT_TRUE(contains(found.notes, notes::endIsBall));
    EXPECT_TRUE(found.unexplained.empty());
    // Segment of the ball π h² (3R - h)/3 and the rows behind it.
    const double volume = std::numbers::pi * (18 * 18 * 12 / 3.0 + 36 * 25 + 81 * 15 + (81 + 72 + 64) / 3.0);
    EXPECT_NEAR(found.volume_mm3.value(), volume, 2e-3 * volume);
}

TEST(BallEnd, QuarterAtTheChuck)
{
    RecognitionParameters parameters;
    parameters.free_end = FreeEnd::Last;
    const Recognition found = recognize(scanShaft(ballPart(8, 0, std::numbers::pi / 2), quiet(6)), parameters);
    ASSERT_EQ(found.marks.size(), 1U);
    EXPECT_NEAR(found.length_mm.value(), 49, 0.02);
    EXPECT_NEAR(found.marks[0].diameter_mm.value(), 16, found.marks[0].uncertainty_mm.value() + 0.001);
    EXPECT_NEAR(found.marks[0].z_end_mm.value(), found.length_mm.value(), 1e-9);
    EXPECT_EQ(found.segments.back().end_diameter_mm, 0);
    EXPECT_EQ(found.ends[1].closed_by, "round");
}

TEST(BallEnd, FlatOrRoundedEndIsNone)
{
    const Recognition flat =
        recognize(scanShaft(ballPart(10, std::asin(0.5), std::numbers::pi - std::asin(0.6)), quiet(7)), {});
    EXPECT_TRUE(flat.marks.empty());
    EXPECT_NEAR(flat.segments[0].start_diameter_mm, 10, 0.2);
    sample::ShaftModel round;
    addArc(round, 0, 2, 2, 8, 2, true);
    round.push_back(piece(2, 30, 20, 20));
    EXPECT_TRUE(recognize(scanShaft(round, quiet(8)), {}).marks.empty());
}

/// A roller ⌀50 between journals, its ends `crown` lower on the radius than its middle.
sample::ShaftModel roller(double length, double crown)
{
    sample::ShaftModel shaft{piece(0, 20, 20, 20)};
    const double R = (length * length / 4 + crown * crown) / (2 * crown);
    constexpr int count = 60;
    const auto at = [&](double x) {
        const double off = x - length / 2;
        return 50 - 2 * (R - std::sqrt(R * R - off * off));
    };
    for (int i = 0; i < count; ++i) {
        const double a = length * i / count, b = length * (i + 1) / count;
        shaft.push_back(piece(20 + a, 20 + b, at(a), at(b)));
    }
    shaft.push_back(piece(20 + length, 40 + length, 20, 20));
    return shaft;
}

TEST(LongArc, CrownedRollerIsOneArc)
{
    const Scan scan = scanShaft(roller(160, 0.1), quiet(9, 0.2));
    for (const double form_mm : {0.02, 0.005}) {
        RecognitionParameters parameters;
        parameters.form_tolerance_mm = form_mm;
        const Recognition found = recognize(scan, parameters);
        ASSERT_EQ(found.segments.size(), 3U) << form_mm;
        const RecognizedRow& arc = found.segments[1];
        ASSERT_EQ(arc.kind, RowKind::Arc);
        EXPECT_LT(arc.uncertainty.arc_radius_um.value(), 0.03 * 32000e3);
        EXPECT_NEAR(arc.arc_radius_mm.value(), 32000, 1.5e-3 * arc.uncertainty.arc_radius_um.value());
        EXPECT_NEAR(arc.start_diameter_mm, 49.8, 0.003);
        EXPECT_NEAR(arc.end_diameter_mm, 49.8, 0.003);
    }
}

TEST(LongArc, WornBarrelStaysACylinder)
{
    const Recognition found = recognize(scanShaft(roller(60, 0.025), quiet(10, 0.2)), {});
    ASSERT_EQ(found.segments.size(), 3U);
    EXPECT_EQ(found.segments[1].kind, RowKind::Cylinder);
    // The least-squares cylinder of a parabola lies a third of its height below the crown.
    EXPECT_NEAR(found.segments[1].start_diameter_mm, 50 - 0.05 / 3, 0.002);
    EXPECT_NEAR(found.segments[1].form_pv_um, 25, 3);
}

TEST(LongArc, OfAnyRadiusIsOnePiece)
{
    for (const double R : {200.0, 4000.0, 32000.0, 300000.0}) {
        std::vector<Wall> walls;
        for (int i = 0; i < 1600; ++i) {
            const double z = 100 + 0.1 * i, off = 0.1 * i - 60;
            Wall wall;
            wall.z_mm = z;
            wall.points = 200;
            wall.sigma_mm = 0.02;
            wall.r_mm = 40 - off * off / (R + std::sqrt(R * R - off * off)) +
                        0.002 * randomNormal(12, 0, static_cast<std::uint64_t>(i));
            walls.push_back(wall);
        }
        const std::vector<Piece> pieces = cutIntoPieces(walls);
        ASSERT_EQ(pieces.size(), 1U) << R;
        EXPECT_TRUE(pieces[0].arc);
        EXPECT_EQ(pieces[0].flat, R > 3200) << R;
        // 2 µm of noise over 1600 walls: the sagitta is known to 0.2 µm.
        EXPECT_NEAR(pieces[0].radius_mm / R, 1, 1e-3 + 3e-3 * R / 16000) << R;
    }
}

TEST(SteepFlank, OfAPulleyIsACone)
{
    for (const double angle_deg : {72.0, 75.0}) {
        const double length = 6 / std::tan(angle_deg * std::numbers::pi / 180);
        const sample::ShaftModel pulley{
            piece(0, 8, 40, 40), piece(8, 8 + length, 40, 28), piece(8 + length, 14 + length, 28, 28),
            piece(14 + length, 14 + 2 * length, 28, 40), piece(14 + 2 * length, 22 + 2 * length, 40, 40)};
        const Recognition found = recognize(scanShaft(pulley, quiet(11, 0.05)), {});
        EXPECT_TRUE(found.gaps.empty());
        ASSERT_EQ(found.segments.size(), 5U) << angle_deg;
        EXPECT_NEAR(found.segments[1].half_angle_deg, -angle_deg, 0.15);
        EXPECT_NEAR(found.segments[3].half_angle_deg, angle_deg, 0.15);
        EXPECT_NEAR(found.segments[2].z_end_mm - found.segments[2].z_start_mm, 6, 0.02);
        EXPECT_NEAR(found.segments[2].start_diameter_mm, 28, 0.003);
    }
}

TEST(SteepFlank, FaceAcrossTheAxisIsNone)
{
    // A shoulder of 4 mm whose face is seen: one bin holds radii from 20 to 24.
    std::vector<Wall> walls;
    for (int i = 0; i < 12; ++i) {
        Wall wall;
        wall.z_mm = 0.1 * i;
        wall.r_mm = i < 6 ? 20 : i == 6 ? 22 : 24;
        wall.spread_mm = i == 6 ? 3.4 : 0.05;
        wall.sigma_mm = i == 6 ? 1.2 : 0.02;
        wall.points = 100;
        walls.push_back(wall);
    }
    std::vector<std::vector<Wall*>> bins;
    for (Wall& wall : walls) bins.push_back({&wall});
    findSteepWalls(bins, 0.02, 0.1);
    for (const Wall& wall : walls) EXPECT_EQ(wall.slope, 0);
    // A flank of 75° over the same height.
    for (int i = 0; i < 12; ++i) {
        walls[static_cast<std::size_t>(i)].r_mm = 20 + std::tan(75 * std::numbers::pi / 180) * 0.1 * i;
        walls[static_cast<std::size_t>(i)].spread_mm = 0.84 * 0.373;
        walls[static_cast<std::size_t>(i)].sigma_mm = 0.11;
    }
    findSteepWalls(bins, 0.02, 0.1);
    EXPECT_EQ(walls[0].slope, 0);  // of the first and the last the neighbours say nothing
    for (std::size_t i = 1; i < 11; ++i) EXPECT_NEAR(walls[i].slope, 3.732, 0.001);
}

}  // namespace
}  // namespace lathelier::features
