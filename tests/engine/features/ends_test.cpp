// Ends of parts: decided by rows, shapes and faces, else undecided with the span in which they lie; stated lengths.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../core/code_of_error.h"
#include "engine/core/understanding.h"
#include "engine/features/features_codes.h"
#include "engine/features/recognition.h"
#include "engine/features/refit/refit.h"
#include "shaped_scan.h"

namespace lathelier::features {
namespace {

/// Ø20 x 31, collar Ø35 from 31 to 51, Ø22 to 91; chamfers 1 × 45° at both ends, or none.
sample::ShaftModel steppedPart(bool chamfers)
{
    if (!chamfers) return {piece(0, 31, 20, 20), piece(31, 51, 35, 35), piece(51, 92, 22, 22)};
    return {piece(0, 1, 18, 20), piece(1, 31, 20, 20), piece(31, 51, 35, 35), piece(51, 91, 22, 22),
            piece(91, 92, 22, 20)};
}

sample::ScannerModel rows(double pitch_mm, double tilt_deg, std::uint64_t seed)
{
    sample::ScannerModel scanner;
    scanner.seed = seed;
    scanner.sigma_mm = 0.03;
    scanner.row_pitch_mm = pitch_mm;
    scanner.angle_step_deg = 1.5;
    scanner.scan_T_part = Eigen::Isometry3d(
        Eigen::Translation3d(0.3, 0.7, 0.013 * static_cast<double>(seed)) *
        Eigen::AngleAxisd(tilt_deg * std::numbers::pi / 180, Eigen::Vector3d(0.87, 0.5, 0).normalized()));
    return scanner;
}

void expectLength(const Recognition& r, double length_mm, const char* closed_by)
{
    ASSERT_EQ(r.ends.size(), 2U);
    for (const RecognizedEnd& end : r.ends) {
        EXPECT_EQ(end.closed_by, closed_by);
        ASSERT_TRUE(end.span_mm);
        EXPECT_LE(end.span_mm->from, end.z_mm);
        EXPECT_GE(end.span_mm->to, end.z_mm);
    }
    ASSERT_TRUE(r.length_mm);
    EXPECT_NEAR(*r.length_mm, length_mm, 1.5 * r.length_uncertainty_mm);
    EXPECT_LT(r.length_uncertainty_mm, 0.15);
    EXPECT_TRUE(r.complete);
}

TEST(Ends, RowsWiderThanTheTilt)
{
    // 2 R tilt is 0.03 to 0.14 mm: all rays may end in one row, which the edge of a window would do too.
    for (const double pitch_mm : {0.1, 0.15, 0.2})
        for (const double tilt_deg : {0.0, 0.1, 0.3}) {
            SCOPED_TRACE(testing::Message() << "pitch " << pitch_mm << " mm, tilt " << tilt_deg << "°");
            expectLength(recognize(scanShaft(steppedPart(true), rows(pitch_mm, tilt_deg, 5)), {}), 92, "chamfer");
        }
}

/// One row of rays on a chamfer may be one of any shape, and the part may go on up to where the next row would be.
TEST(Ends, AChamferInOneRowIsUndecided)
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const Recognition r = recognize(scanShaft(steppedPart(true), rows(1.0, 0.3, seed)), {});
        ASSERT_EQ(r.ends.size(), 2U);
        EXPECT_FALSE(r.length_mm);
        ASSERT_TRUE(r.ends[0].span_mm && r.ends[1].span_mm);
        EXPECT_LT(r.ends[1].span_mm->from - r.ends[0].span_mm->to, 92);
        EXPECT_GT(r.ends[1].span_mm->to - r.ends[0].span_mm->from, 92);
    }
}

TEST(Ends, APlainEdgeBetweenRows)
{
    // Rays of the last row pass the edge within the spot: some hit, some do not.
    expectLength(recognize(scanShaft(steppedPart(false), rows(0.1, 0.1, 7)), {}), 92, "edge");
    expectLength(recognize(scanShaft(steppedPart(false), rows(0.05, 0.4, 8)), {}), 92, "edge");
}

TEST(Ends, AThreadUpToTheEnd)
{
    const auto threaded = [](const AroundPoint& p) -> std::optional<double> {
        if (p.z_mm > 14) return p.r_mm;
        const double turn = p.z_mm / 2 - p.angle_rad / (2 * std::numbers::pi), u = turn - std::floor(turn);
        return p.r_mm - std::clamp((0.875 - 2 * std::abs(u - 0.5)) * std::numbers::sqrt3, 0.0, 1.0);
    };
    const Recognition r = recognize(shapedScan(steppedPart(false), rows(0.1, 0.2, 9), threaded), {});
    ASSERT_EQ(r.ends.size(), 2U);
    EXPECT_EQ(r.ends[0].closed_by, "edge");
    ASSERT_TRUE(r.length_mm);
    EXPECT_NEAR(*r.length_mm, 92, 1.5 * r.length_uncertainty_mm);
}

TEST(Ends, AWindowIsNoEnd)
{
    for (const double pitch_mm : {0.05, 0.1, 0.2})
        for (const double tilt_deg : {0.0, 0.2, 0.4}) {
            sample::ScannerModel scanner = rows(pitch_mm, tilt_deg, 11);
            scanner.scan_z_from_mm = 8.3;
            scanner.scan_z_to_mm = 84.1;
            const Recognition r = recognize(scanShaft(steppedPart(true), scanner), {});
            ASSERT_EQ(r.ends.size(), 2U);
            for (const RecognizedEnd& end : r.ends) EXPECT_FALSE(isClosed(end)) << pitch_mm << ' ' << tilt_deg;
            EXPECT_FALSE(r.length_mm);
            EXPECT_FALSE(r.complete);
        }
}

/// Rows lie across the part, and no ray of a narrow spot passes its edges: nothing tells its ends from those of data.
Recognition undecided(std::optional<double> length_mm = {})
{
    sample::ScannerModel scanner = rows(0.2, 0, 1);
    scanner.scan_T_part = Eigen::Isometry3d(Eigen::Translation3d(0.3, 0.7, 0.1));
    scanner.spot_mm = 0.02;
    RecognitionParameters parameters;
    parameters.length_mm = length_mm;
    return recognize(scanShaft(steppedPart(false), scanner), parameters);
}

TEST(Ends, UndecidedWithItsSpan)
{
    const Recognition r = undecided();
    ASSERT_EQ(r.ends.size(), 2U);
    EXPECT_FALSE(r.length_mm);
    EXPECT_TRUE(contains(r.notes, notes::endUndecided));
    EXPECT_FALSE(contains(r.notes, notes::endNotSeen));
    const double zero = r.part_T_scan.translation().z();
    for (const RecognizedEnd& end : r.ends) {
        EXPECT_EQ(end.closed_by, "undecided");
        ASSERT_TRUE(end.span_mm);
        // z of the scan is that of the part + 0.1.
        const double truth = (&end == &r.ends[0] ? 0.1 : 92.1) + zero;
        EXPECT_LT(end.span_mm->from, truth);
        EXPECT_GT(end.span_mm->to, truth);
        EXPECT_LT(end.span_mm->to - end.span_mm->from, 0.25);
    }
}

TEST(Ends, AConfirmedLengthClosesThem)
{
    const Recognition r = undecided(92);
    EXPECT_TRUE(r.complete);
    ASSERT_TRUE(r.length_mm);
    EXPECT_NEAR(*r.length_mm, 92, 1e-9);
    for (const RecognizedEnd& end : r.ends) EXPECT_EQ(end.closed_by, "edge");
    EXPECT_NEAR(r.shaft.length_mm(), 92, 1e-9);
    EXPECT_EQ(understandingOf(r.notes).assumed.size(), 2U);
    EXPECT_EQ(understandingOf(r.notes).assumed.front().what, "end_confirmed");
    const Recognition changed = refit(r, {{RowChange::What::Cone, 2}});
    ASSERT_TRUE(changed.length_mm);
    EXPECT_NEAR(*changed.length_mm, 92, 1e-3);
    EXPECT_TRUE(contains(changed.notes, notes::endConfirmed));

    EXPECT_EQ(codeOfError([] { undecided(91.5); }), errors::lengthAgainstData);
    // The part may go on where its end is not decided.
    EXPECT_NEAR(*undecided(95).length_mm, 95, 1e-9);
}

TEST(Ends, AStatedLengthStretchesNoChamfer)
{
    const Scan scan = scanShaft(steppedPart(true), rows(0.1, 0.2, 13));
    const Recognition plain = recognize(scan, {});
    RecognitionParameters stated;
    stated.length_mm = 92;
    const Recognition same = recognize(scan, stated);
    ASSERT_EQ(same.segments.size(), plain.segments.size());
    for (std::size_t i = 0; i < plain.segments.size(); ++i) {
        EXPECT_EQ(same.segments[i].z_end_mm, plain.segments[i].z_end_mm);
        EXPECT_EQ(same.segments[i].role, plain.segments[i].role);
    }
    for (const double wrong : {100.0, 92.2, 91.8, 85.0}) {
        stated.length_mm = wrong;
        try {
            recognize(scan, stated);
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::lengthAgainstData);
            EXPECT_EQ(std::get<double>(*find(error.values(), "length_mm")), wrong);
            EXPECT_NEAR(std::get<double>(*find(error.values(), "data_mm")), 92, 0.05);
        }
    }
}

TEST(Ends, AWindowIsClosedByAStatedLength)
{
    sample::ScannerModel scanner = rows(0.1, 0.2, 15);
    scanner.scan_z_to_mm = 84.1;
    RecognitionParameters stated;
    stated.length_mm = 92;
    const Recognition r = recognize(scanShaft(steppedPart(true), scanner), stated);
    ASSERT_TRUE(r.length_mm);
    EXPECT_NEAR(*r.length_mm, 92, 1e-9);
    EXPECT_NEAR(r.segments.back().z_end_mm, 92, 1e-9);
    EXPECT_NEAR(r.segments.back().start_diameter_mm, 22, 0.01);
    EXPECT_EQ(r.ends[0].closed_by, "chamfer");
    stated.length_mm = 80;
    EXPECT_EQ(codeOfError([&] { recognize(scanShaft(steppedPart(true), scanner), stated); }),
              errors::lengthAgainstData);

    // Scanned from the other side: what the free end lacks moves all of z.
    sample::ScannerModel from = rows(0.1, 0.2, 15);
    from.scan_z_from_mm = 8;
    stated.length_mm = 92;
    const Recognition front = recognize(scanShaft(steppedPart(true), from), stated);
    EXPECT_NEAR(front.segments[0].z_end_mm, 31, 0.05);
    EXPECT_NEAR(front.segments.back().z_end_mm, 92, 1e-9);
}

/// A surface scan of walls alone: 25 points/mm² of Ø20 x 40, Ø30 x 30, Ø24 x 37, none within 0.1 mm of their edges.
Scan wallsAlone(std::uint32_t seed)
{
    struct Seat {
        double from_mm, to_mm, r_mm;
    };
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> even(0, 1);
    std::normal_distribution<double> noise(0, 0.02);
    Scan scan;
    // A chamfer 1 × 45° at both ends closes the part.
    for (const Seat& seat : {Seat{1, 40, 10}, Seat{40, 70, 15}, Seat{70, 106, 12}}) {
        const double from = seat.from_mm + 0.1, to = seat.to_mm - 0.1;
        const auto count = static_cast<int>(25 * 2 * std::numbers::pi * seat.r_mm * (to - from));
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * even(random), r = seat.r_mm + noise(random);
            scan.points_mm.emplace_back(r * std::cos(angle), r * std::sin(angle), from + (to - from) * even(random));
        }
    }
    for (const bool start : {true, false}) {
        const double r_mm = start ? 10 : 12;
        for (int i = 0; i < 2000; ++i) {
            const double angle = 2 * std::numbers::pi * even(random), along = 0.07 + 0.86 * even(random);
            const double off = noise(random) / std::numbers::sqrt2, r = r_mm - 1 + along + off;
            const double z = start ? along - off : 107 - along + off;
            scan.points_mm.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        }
    }
    std::shuffle(scan.points_mm.begin(), scan.points_mm.end(), random);
    return scan;
}

TEST(Ends, UnseenFacesCarryWhatIsLostBesideEdges)
{
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const Recognition r = recognize(wallsAlone(seed), {});
        ASSERT_TRUE(r.length_mm) << seed;
        EXPECT_NEAR(*r.length_mm, 107, r.length_uncertainty_mm) << seed;
        EXPECT_LT(r.length_uncertainty_mm, 0.5) << seed;
    }
}

}  // namespace
}  // namespace lathelier::features
