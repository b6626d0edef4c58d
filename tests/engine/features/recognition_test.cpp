// From scan to table: parts with known sizes under the sample's scanner.
#include "engine/features/recognition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "../core/code_of_error.h"
#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/features/features_codes.h"
#include "engine/registration/registration_codes.h"
#include "engine/shaft/shaft_rules.h"
#include "made_scan.h"

namespace lathelier::features {
namespace {

bool has(const Notes& notes, const NoteCode& code)
{
    return std::any_of(notes.begin(), notes.end(), [&](const Note& note) { return note.code == code; });
}

TEST(Recognition, ThePapersShaft)
{
    const Recognition& r = scannedTableOne();
    ASSERT_EQ(r.segments.size(), 4U);
    const double diameters[] = {30, 37, 33.8, 33.8}, edges[] = {98, 108, 178, 183};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(r.segments[i].start_diameter_mm, diameters[i], 2e-3) << i;
        EXPECT_NEAR(r.segments[i].z_end_mm, edges[i], i == 3 ? 0.06 : 0.03) << i;
    }
    EXPECT_EQ(r.segments[3].kind, RowKind::Cone);
    EXPECT_EQ(r.segments[3].role, "chamfer");
    EXPECT_NEAR(r.segments[3].half_angle_deg, -45, 0.1);
    ASSERT_TRUE(r.length_mm);
    EXPECT_NEAR(*r.length_mm, 183, 0.06);
    EXPECT_TRUE(r.complete);
    EXPECT_NEAR(*r.volume_mm3, 146123.0665, 40);
    EXPECT_NEAR(r.noise_mm, 0.05, 0.002);
    EXPECT_LT(r.chi2_per_bin, 1.3);
    EXPECT_TRUE(has(r.notes, notes::uncertaintyNoiseOnly));
    EXPECT_TRUE(checkShaft(r.shaft).empty());
}

TEST(Recognition, NominalSizesAreAppliedOnlyWhenAsked)
{
    RecognitionParameters parameters;
    parameters.snap = Snap::Apply;
    const Recognition r = recognize(scanShaft(sample::nominalShaft(), askew(3)), parameters);
    ASSERT_EQ(r.shaft.segments.size(), 4U);
    EXPECT_NEAR(r.shaft.segments[0].start_diameter_mm, 30, 1e-9);
    EXPECT_NEAR(r.shaft.segments[0].length_mm, 98, 1e-9);
    EXPECT_NEAR(r.shaft.segments[3].length_mm, 5, 1e-9);
    EXPECT_NEAR(r.shaft.segments[3].end_diameter_mm, 23.8, 1e-9);
    ASSERT_TRUE(r.shaft.segments[0].measured);
    EXPECT_NE(*r.shaft.segments[0].measured->start_diameter_mm, 30.0);
    EXPECT_NE(scannedTableOne().shaft.segments[0].start_diameter_mm, 30.0);  // suggested, not applied
    EXPECT_FALSE(scannedTableOne().segments[0].suggestions.empty());
}

TEST(Recognition, RoundsFilletsTapersAndGrooves)
{
    const Recognition r = recognize(scanShaft(featurePart(), askew(5)), {});
    ASSERT_EQ(r.segments.size(), 10U);
    EXPECT_EQ(r.segments[0].kind, RowKind::Arc);
    EXPECT_NEAR(*r.segments[0].arc_radius_mm, 1, 0.05);
    EXPECT_EQ(r.segments[2].kind, RowKind::Arc);
    EXPECT_NEAR(*r.segments[2].arc_radius_mm, -0.8, 0.04);
    EXPECT_EQ(r.segments[4].kind, RowKind::Cone);
    EXPECT_NEAR(r.segments[4].half_angle_deg, std::atan(0.05) * 180 / M_PI, 0.02);
    EXPECT_NEAR(r.segments[7].start_diameter_mm, 38, 6e-3);
    EXPECT_NEAR(r.segments[7].z_end_mm - r.segments[7].z_start_mm, 2, 0.02);
    EXPECT_EQ(r.segments[7].role, "groove");
    EXPECT_EQ(r.segments[9].role, "chamfer");
}

TEST(Recognition, StatedUncertaintiesHold)
{
    int inside = 0, all = 0;
    const double diameters[] = {30, 37, 33.8}, edges[] = {98, 108};
    for (std::uint64_t seed = 20; seed < 28; ++seed) {
        sample::ScannerModel scanner = askew(seed);
        scanner.row_pitch_mm = 0.2;
        scanner.angle_step_deg = 1.8;
        const Recognition r = recognize(scanShaft(sample::nominalShaft(), scanner), {});
        ASSERT_EQ(r.segments.size(), 4U) << seed;
        for (std::size_t i = 0; i < 3; ++i) {
            inside += std::abs(r.segments[i].start_diameter_mm - diameters[i]) * 1e3 <=
                      *r.segments[i].uncertainty.start_diameter_um;
            ++all;
        }
        for (std::size_t i = 0; i < 2; ++i) {  // lengths between planes: the origin's own error is not in them
            const double length = r.segments[i + 1].z_end_mm - r.segments[i + 1].z_start_mm, truth = i == 0 ? 10 : 70;
            inside += std::abs(length - truth) * 1e3 <= *r.segments[i + 1].uncertainty.length_um;
            ++all;
        }
        EXPECT_NEAR(r.segments[1].z_start_mm, edges[0], 0.08);
    }
    EXPECT_GE(inside, all * 85 / 100) << inside << " of " << all;
}

/// What a row truly is; a length only between planes, where no corner's place adds to it.
struct TrueRow {
    double diameter_mm = 0;                ///< of a cylinder; 0: none
    std::optional<double> length_mm = {};  ///< between planes
    std::optional<double> arc_mm = {};     ///< of an arc, without sign
    std::optional<double> angle_deg = {};  ///< of a cone, without sign
};

struct Coverage {
    int inside = 0, all = 0;
    double squares = 0;  ///< of errors by standard uncertainty
    void add(double error, std::optional<double> U)
    {
        ASSERT_TRUE(U && *U > 0);
        inside += std::abs(error) <= *U;
        squares += 4 * error * error / (*U * *U);
        ++all;
    }
};

void addCoverage(const sample::ShaftModel& part, const std::vector<TrueRow>& truth, std::uint64_t seed,
                 Coverage& coverage)
{
    sample::ScannerModel scanner = askew(seed);
    scanner.row_pitch_mm = 0.15;
    scanner.angle_step_deg = 1.8;
    const Recognition r = recognize(scanShaft(part, scanner), {});
    ASSERT_EQ(r.segments.size(), truth.size()) << seed;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const RecognizedRow& row = r.segments[i];
        const SizeUncertainty& u = row.uncertainty;
        if (truth[i].diameter_mm > 0)
            coverage.add(1e3 * (row.start_diameter_mm - truth[i].diameter_mm), u.start_diameter_um);
        if (truth[i].length_mm) coverage.add(1e3 * (row.z_end_mm - row.z_start_mm - *truth[i].length_mm), u.length_um);
        if (truth[i].arc_mm && row.arc_radius_mm)
            coverage.add(1e3 * (std::abs(*row.arc_radius_mm) - *truth[i].arc_mm), u.arc_radius_um);
        if (truth[i].angle_deg) coverage.add(std::abs(row.half_angle_deg) - *truth[i].angle_deg, u.angle_deg);
    }
}

/// Expanded uncertainties (k = 2) hold 95 % of all errors, of parts and sizes of all kinds together.
TEST(Recognition, UncertaintiesCoverTheirErrors)
{
    const char* const asked = std::getenv("LATHELIER_COVERAGE_SEEDS");  // more of them take longer
    const std::uint64_t seeds = asked ? std::strtoull(asked, nullptr, 10) : 4;
    const double slope_deg = std::atan(0.05) * 180 / M_PI;
    sample::ShaftModel spindle{piece(0, 1.5, 17, 20), piece(1.5, 30, 20, 20), piece(30, 32, 18.6, 18.6),
                               piece(32, 50, 25, 25), piece(50, 70, 25, 40),  piece(70, 90, 40, 40)};
    const double steep_deg = std::atan(7.5 / 20) * 180 / M_PI;
    const std::vector<std::pair<sample::ShaftModel, std::vector<TrueRow>>> parts{
        {sample::nominalShaft(), {{30}, {37, 10}, {33.8}, {0, {}, {}, 45}}},
        {featurePart(),
         {{0, {}, 1},
          {16},
          {0, {}, 0.8},
          {24},
          {0, {}, {}, slope_deg},
          {28},
          {42, 10},
          {38, 2},
          {42},
          {0, {}, {}, 45}}},
        {spindle, {{0, {}, {}, 45}, {20}, {18.6, 2}, {25}, {0, {}, {}, steep_deg}, {40}}}};
    Coverage coverage;
    for (std::uint64_t seed = 100; seed < 100 + seeds; ++seed)
        for (const auto& [part, truth] : parts) addCoverage(part, truth, seed, coverage);
    const double percent = 100.0 * coverage.inside / coverage.all;
    RecordProperty("coverage_percent", static_cast<int>(percent + 0.5));
    EXPECT_GE(percent, 90) << coverage.inside << " of " << coverage.all;
    EXPECT_LE(percent, 99.5) << coverage.inside << " of " << coverage.all;
    EXPECT_NEAR(std::sqrt(coverage.squares / coverage.all), 1, 0.25);  // neither too small nor too large
}

TEST(Recognition, AWornSeatIsOneRowWithItsForm)
{
    sample::ShaftModel worn = sample::nominalShaft();
    worn[0].barrel_um = 15;
    worn[2].taper_start_um = 0;
    worn[2].taper_end_um = -12;
    const Recognition r = recognize(scanShaft(worn, askew(7)), {});
    ASSERT_EQ(r.segments.size(), 4U);
    EXPECT_EQ(r.segments[0].kind, RowKind::Cylinder);
    EXPECT_NEAR(r.segments[0].start_diameter_mm, 30 + 4 * 0.015 / 3, 2e-3);  // least squares over the seat
    EXPECT_NEAR(r.segments[0].form_pv_um, 15, 3);
    EXPECT_EQ(r.segments[2].kind, RowKind::Cylinder);
    EXPECT_NEAR(r.segments[2].taper_um, -12, 3);
    // Without the tolerance nothing is merged.
    RecognitionParameters exact;
    exact.form_tolerance_mm = 0;
    const Recognition all = recognize(scanShaft(worn, askew(7)), exact);
    EXPECT_EQ(all.segments[0].kind, RowKind::Arc);
    EXPECT_EQ(all.segments[2].kind, RowKind::Cone);
    EXPECT_TRUE(all.merged.empty());
}

TEST(Recognition, TurnedEndForEndAndAnywhereInSpace)
{
    sample::ScannerModel scanner = askew(3);
    scanner.frame_T_scan = Eigen::Isometry3d(Eigen::Translation3d(300, -50, 700) *
                                             Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 0.3).normalized()));
    RecognitionParameters parameters;
    const Recognition moved = recognize(scanShaft(sample::nominalShaft(), scanner), parameters);
    ASSERT_EQ(moved.segments.size(), 4U);
    parameters.free_end = FreeEnd::Last;
    const Recognition turned = recognize(scanShaft(sample::nominalShaft(), scanner), parameters);
    ASSERT_EQ(turned.segments.size(), 4U);
    const bool chamfer_first = moved.segments.front().kind == RowKind::Cone;
    const Recognition& plain = chamfer_first ? turned : moved;
    const Recognition& flipped = chamfer_first ? moved : turned;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(plain.segments[i].start_diameter_mm, scannedTableOne().segments[i].start_diameter_mm, 1.5e-3) << i;
        EXPECT_NEAR(flipped.segments[3 - i].end_diameter_mm, plain.segments[i].start_diameter_mm, 1e-3) << i;
        EXPECT_NEAR(flipped.segments[3 - i].z_end_mm, *plain.length_mm - plain.segments[i].z_start_mm, 0.02) << i;
    }
}

TEST(Recognition, TheSameBitsForAnyNumberOfThreads)
{
    const Scan scan = scanShaft(sample::nominalShaft(), askew(3));
    const ThreadLimit one(1);
    const Recognition r = recognize(scan, {});
    ASSERT_EQ(r.segments.size(), scannedTableOne().segments.size());
    for (std::size_t i = 0; i < r.segments.size(); ++i) {
        EXPECT_EQ(r.segments[i].start_diameter_mm, scannedTableOne().segments[i].start_diameter_mm);
        EXPECT_EQ(r.segments[i].z_end_mm, scannedTableOne().segments[i].z_end_mm);
    }
}

TEST(Recognition, WhatIsNotSeenIsNotInvented)
{
    sample::ScannerModel scanner = askew(9);
    scanner.scan_z_from_mm = 20;
    scanner.scan_z_to_mm = 120;
    const Recognition window = recognize(scanShaft(sample::nominalShaft(), scanner), {});
    EXPECT_FALSE(window.length_mm);
    EXPECT_FALSE(window.complete);
    EXPECT_TRUE(has(window.notes, notes::endNotSeen));
    EXPECT_EQ(window.ends.front().closed_by, "data");

    Scan gap = scanShaft(sample::nominalShaft(), askew(9));
    std::erase_if(gap.points_mm, [](const Eigen::Vector3d& p) { return p.z() > 40 && p.z() < 60; });
    const Recognition holed = recognize(gap, {});
    ASSERT_EQ(holed.gaps.size(), 1U);
    EXPECT_NEAR(holed.gaps[0].z_start_mm, 40, 0.3);
    EXPECT_NEAR(holed.gaps[0].z_end_mm, 60, 0.3);
    EXPECT_FALSE(holed.complete);
    EXPECT_TRUE(has(holed.notes, notes::gapInData));

    RecognitionParameters parameters;
    parameters.length_mm = 200;
    const Recognition stated = recognize(scanShaft(sample::nominalShaft(), scanner), parameters);
    EXPECT_EQ(*stated.length_mm, 200);
    EXPECT_TRUE(has(stated.notes, notes::endConfirmed));
}

TEST(Recognition, RefusesWhatIsNoTurnedPart)
{
    Scan few;
    for (int i = 0; i < 30; ++i) few.points_mm.emplace_back(std::cos(i), std::sin(i), i);
    EXPECT_EQ(codeOfError([&] { recognize(few, {}); }), errors::tooFewPoints);
    const Scan bracket = sample::scanBracket(20000, 0.03, Eigen::Isometry3d::Identity(), 1);
    EXPECT_EQ(codeOfError([&] { recognize(bracket, {}); }), errors::notABodyOfRevolution);
}

TEST(Recognition, CanBeCancelled)
{
    const Scan scan = scanShaft(sample::nominalShaft(), askew(3));
    // Stopped at its beginning, in the middle and near its end.
    for (const double moment : {0.1, 0.5, 0.7}) {
        std::stop_source stop;
        const Progress progress(stop.get_token(), [&](double fraction, Text) {
            if (fraction >= moment) stop.request_stop();
        });
        EXPECT_THROW(recognize(scan, {}, progress), Cancelled) << moment;
    }
}

}  // namespace
}  // namespace lathelier::features
