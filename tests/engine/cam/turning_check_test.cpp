// Programs with known faults: none found in correct programs, every planted fault found at its line.
#include "engine/cam/check/turning_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cam_data.h"
#include "engine/cam/cam_codes.h"

namespace lathelier::cam {
namespace {

void expectRestWithin(const CheckResult& result, double from, double to, double left, RestCause cause)
{
    const RestInterval* rest = restAt(result, (from + to) / 2);
    ASSERT_TRUE(rest) << from;
    EXPECT_NEAR(rest->z_start_mm, from, 0.05);
    EXPECT_NEAR(rest->z_end_mm, to, 0.05);
    EXPECT_NEAR(rest->left_mm, left, 0.002);
    EXPECT_EQ(rest->cause, cause) << key(rest->cause);
}

TEST(TurningCheck, SoundProgramsHaveNothingButTheirCorners)
{
    const CheckResult contour = checked(textOf("contour_fanuc_a.nc"), jobOf("contour"));
    EXPECT_TRUE(contour.findings.empty());
    EXPECT_TRUE(contour.rest.empty());
    EXPECT_LT(contour.gouge_um, 1.5);
    EXPECT_EQ(contour.verdict, Verdict::Pass);

    const CheckResult shaft = checked(textOf("paper_s1_fanuc_a.nc"), jobOf("paper_s1"));
    EXPECT_TRUE(shaft.findings.empty());
    ASSERT_EQ(shaft.rest.size(), 1U);
    expectRestWithin(shaft, 97.65, 98, 0.1657, RestCause::NoseRadius);
    EXPECT_EQ(shaft.verdict, Verdict::Fail);

    const CheckResult neck = checked(textOf("neck_all_fanuc_a.nc"), jobOf("neck_all"));
    EXPECT_TRUE(neck.findings.empty());
    ASSERT_EQ(neck.rest.size(), 4U);
    expectRestWithin(neck, 27, 27.16, 0.0828, RestCause::Blade);
    expectRestWithin(neck, 29.84, 30, 0.0828, RestCause::Blade);
    expectRestWithin(neck, 88.99, 89.02, 0.0052, RestCause::NoseRadius);
    EXPECT_NEAR(neck.rest[3].left_mm, 0.0126, 0.002);
    EXPECT_LT(neck.gouge_um, 1.5);
}

TEST(TurningCheck, SmallProgramIsSound)
{
    const CheckResult result = checked(textOf("small.nc"), jobOf("small"));
    EXPECT_TRUE(result.findings.empty()) << result.findings.front().line << key(result.findings.front().kind);
    EXPECT_TRUE(result.rest.empty()) << result.rest.front().z_start_mm << ' ' << result.rest.front().left_mm;
    EXPECT_LT(result.gouge_um, 1.5);
    EXPECT_LT(result.left_max_mm, 0.003);
}

TEST(TurningCheck, ContourWithoutCompensationLeavesItsChamfer)
{
    // The nominal contour run with the imaginary tip leaves r (√2 - 1) on a cone of 45°.
    std::string text = textOf("small.nc");
    text = replaced(text, "N320 G3 X17.766 Z-0.117 I0. K-0.4", "N320 G1 X18.");
    text = replaced(text, "N330 G1 X19.766 Z-1.117", "N330 G1 X20. Z-1.");
    text = replaced(text, "N340 G3 X20. Z-1.4 I-0.283 K-0.283", "N340 G1 Z-1.4");
    const CheckResult result = checked(text, jobOf("small"));
    EXPECT_TRUE(result.findings.empty());
    EXPECT_NEAR(result.left_max_mm, 0.4 * (std::sqrt(2.0) - 1), 0.001);
    ASSERT_EQ(result.rest.size(), 1U);
    EXPECT_EQ(result.rest.front().cause, RestCause::Uncut);
    EXPECT_EQ(result.verdict, Verdict::Fail);
}

/// One changed word, with the expected finding and its block.
struct Planted {
    const char* words;
    const char* by;
    CheckKind kind;
    const char* block;  ///< of the fault or its consequence
};

TEST(TurningCheck, FaultsInOneWordAreFoundAtTheirLines)
{
    const std::string sound = textOf("small.nc");
    const Job job = jobOf("small");
    for (const Planted& fault :
         {Planted{"N350 G1 Z-16.4", "N350 G1 X19.97 Z-8.\nN355 X20. Z-16.4", CheckKind::InsertBelowDrawing, "N350"},
          Planted{"N120 X30.6", "N120 X26.6", CheckKind::InsertBelowDrawing, "N130"},
          Planted{"N170 G1 Z-17.7", "N170 G0 Z-17.7", CheckKind::RapidThroughStock, "N170"},
          Planted{"N130 G1 Z-30.3", "N130 G1 Z-63.3", CheckKind::Chuck, "N130"}}) {
        const std::string text = replaced(sound, fault.words, fault.by);
        const CheckResult result = checked(text, job);
        const std::int64_t line = lineOf(text, fault.block);
        bool is_found = false;
        for (const CheckFinding& finding : result.findings) {
            is_found = is_found || (finding.kind == fault.kind && std::abs(finding.line - line) <= 1);
            EXPECT_LE(std::abs(finding.line - line), 1) << fault.by << ' ' << finding.line << key(finding.kind);
        }
        EXPECT_TRUE(is_found) << fault.by;
    }
}

TEST(TurningCheck, ArcTheOtherWayLeavesItsFillet)
{
    // Three quarters of a turn through the air: no collision, and the fillet is not cut.
    const std::string text = replaced(textOf("small.nc"), "N360 G2", "N360 G3");
    const CheckResult result = checked(text, jobOf("small"));
    ASSERT_EQ(result.rest.size(), 1U);
    EXPECT_NEAR(static_cast<double>(result.rest.front().line), static_cast<double>(lineOf(text, "N360")), 1);
    EXPECT_GT(result.rest.front().left_mm, 0.1);
    EXPECT_EQ(result.rest.front().cause, RestCause::Uncut);
}

TEST(TurningCheck, DepthOfAFaultIsThatOfTheFault)
{
    const std::string text = replaced(textOf("small.nc"), "N350 G1 Z-16.4", "N350 G1 X19.97 Z-8.\nN355 X20. Z-16.4");
    const CheckResult result = checked(text, jobOf("small"));
    EXPECT_NEAR(result.gouge_um, 15, 1);
    ASSERT_TRUE(result.gouge_line);
    EXPECT_NEAR(static_cast<double>(*result.gouge_line), static_cast<double>(lineOf(text, "N350")), 1);
    const CheckResult deep = checked(replaced(textOf("small.nc"), "N120 X30.6", "N120 X26.6"), jobOf("small"));
    ASSERT_FALSE(deep.findings.empty());
    EXPECT_NEAR(deep.findings.front().depth_mm, 1.7, 0.01);
}

TEST(TurningCheck, AnotherNoseAndAnotherInsertAreFound)
{
    Job job = jobOf("small");
    job.tools[1].corner_radius_mm = 0.8;
    const CheckResult nose = checked(textOf("small.nc"), job);
    EXPECT_FALSE(nose.findings.empty() && nose.rest.empty());
    EXPECT_GT(nose.gouge_um + 1000 * nose.left_max_mm, 100);

    // 80° in place of 55°: the nose does not gouge, the back edge cuts into the falling cone.
    job = jobOf("neck_all");
    job.tools[1].tip_angle_deg = 80;
    const std::string text = textOf("neck_all_fanuc_a.nc");
    const CheckResult insert = checked(text, job);
    EXPECT_LT(insert.gouge_um, 1.5);
    const std::int64_t cone = lineOf(text, "Z-89.465");
    bool is_found = false;
    for (const CheckFinding& finding : insert.findings)
        is_found = is_found || (finding.kind == CheckKind::InsertBelowDrawing && std::abs(finding.line - cone) <= 1 &&
                                finding.depth_mm > 0.5);
    EXPECT_TRUE(is_found);
}

TEST(TurningCheck, RapidIntoStockOfAPracticeProgram)
{
    const CheckResult result = checked(textOf("rapid_into_stock_fanuc_a.nc"), jobOf("paper_s1"));
    ASSERT_EQ(result.findings.size(), 1U);
    EXPECT_EQ(result.findings.front().kind, CheckKind::RapidThroughStock);
    EXPECT_EQ(result.findings.front().line, 22);
    EXPECT_NEAR(result.findings.front().depth_mm, 1.62, 0.02);
}

TEST(TurningCheck, CorrectedProgramIsCheckedAgainstDrawingAndCorrection)
{
    const std::string text = replaced(textOf("small.nc"), "N350 G1 Z-16.4", "N350 G1 X19.97 Z-8.\nN355 X20. Z-16.4");
    const Job job = jobOf("small");
    EXPECT_NEAR(checked(text, job).gouge_um, 15, 1);
    CheckInputs inputs;  // where the nose touches, its radius before the tip
    inputs.correction.z_mm = {0, 1, 7.6, 16, 28};
    inputs.correction.radius_mm = {0, 0, -0.015, 0, 0};
    const CheckResult corrected = checked(text, job, {}, inputs);
    EXPECT_LT(corrected.gouge_um, 1.5);
    EXPECT_TRUE(corrected.findings.empty());
    EXPECT_TRUE(corrected.rest.empty());
}

TEST(TurningCheck, SecondClampingStandsOnWhatTheFirstLeft)
{
    // The same small part, turned round: an empty second program leaves the chuck side uncut.
    const Job job = jobOf("small");
    CheckParameters second;
    second.setup = 2;
    CheckInputs inputs;
    inputs.before = textOf("small.nc");
    const CheckResult result = checked("%\nO2\nN10 G21 G18 G40 G99\nM30\n%\n", job, second, inputs);
    EXPECT_TRUE(result.findings.empty());
    ASSERT_EQ(result.rest.size(), 1U);  // the second face
    EXPECT_NEAR(result.rest.front().z_start_mm, 0, 1e-6);
    EXPECT_NEAR(result.rest.front().left_mm, 1, 0.02);
    EXPECT_TRUE(contains(result.notes, notes::secondChuckUnknown));
    // Facing it cuts stock and leaves no residual; a rapid move there collides with the remaining stock.
    const std::string face =
        "%\nO2\nN10 G21 G18 G40 G99\nT0202\nG96 S190 M3\nG0 X38. Z0.\nG1 X-0.8 F0.1\nZ2.\nG0 X38.\nM30\n%\n";
    const CheckResult faced = checked(face, job, second, inputs);
    EXPECT_TRUE(faced.findings.empty());
    EXPECT_TRUE(faced.rest.empty());
    const CheckResult rapid = checked(replaced(face, "G1 X-0.8 F0.1", "G0 X-0.8"), job, second, inputs);
    ASSERT_FALSE(rapid.findings.empty());
    EXPECT_EQ(rapid.findings.front().kind, CheckKind::RapidThroughStock);
}

TEST(TurningCheck, AStatedXZeroIsAPlaceAndAnUnstatedOneIsNot)
{
    const Job job = jobOf("small");
    const auto found = [&](const std::string& start) {
        CheckParameters parameters;
        parameters.program.dialect = "linuxcnc";
        const CheckResult result =
            checked("G21 G18 G40 G90 G7 G95\nT1 M6\nG97 S500 M3\n" + start + "\nG0 X60.\nM2\n", job, parameters);
        return result.findings.size();
    };
    EXPECT_EQ(found("G0 Z-10."), 0U);      // X is unknown before it is programmed
    EXPECT_GT(found("G0 X0. Z-10."), 0U);  // into the bar
}

TEST(TurningCheck, WhatAnUnknownToolCutsLeavesNoVerdict)
{
    const std::string text = textOf("small.nc");
    const std::size_t end = text.find("M30");
    ASSERT_NE(end, std::string::npos);
    std::string more = text;
    more.insert(text.rfind('\n', end) + 1, "T7777\nG97 S500 M3\nG0 X60. Z5.\nG1 X50. F0.1\nG0 X60.\n");
    const Job job = jobOf("small");
    ASSERT_EQ(checked(text, job).verdict, Verdict::Pass);
    const CheckResult result = checked(more, job);
    EXPECT_TRUE(contains(result.notes, notes::toolNotInJob));
    EXPECT_NE(result.verdict, Verdict::Pass);
}

TEST(TurningCheck, ProgramWithErrorsHasNoVerdict)
{
    const CheckResult result = checked("G1 Z-5.\nM30\n", jobOf("small"));
    EXPECT_TRUE(result.path.has_errors);
    EXPECT_FALSE(result.verdict);
}

}  // namespace
}  // namespace lathelier::cam
