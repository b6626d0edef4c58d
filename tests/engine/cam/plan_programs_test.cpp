// Programs in place of planned ones: checked again, read alone, corrected.
#include "engine/cam/plan_programs.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/cam/cam_codes.h"
#include "engine/cam/check/correction_file.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_files.h"
#include "engine/cam/plan_outcome.h"
#include "engine/io/file.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

TurningInputs linuxcnc()
{
    TurningInputs inputs;
    inputs.post = postNamed("linuxcnc");
    return inputs;
}

/// The text with a block more before the finish of the first cylinder.
std::string changed(std::string text, const std::string& block)
{
    const std::size_t pass = text.find("G1 Z-98.", text.find("(FINISH)"));
    EXPECT_NE(pass, std::string::npos) << text;
    return pass == std::string::npos ? text : text.insert(pass, block + "\n");
}

TEST(PlanPrograms, TheSameTextGivesTheSameAnswer)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "linuxcnc", SetupChoice::Two);
    ASSERT_EQ(plan.setups.size(), 2U);
    const TurningPlan again =
        withPrograms(plan, {{0, plan.setups[0].text, {}, true}, {1, plan.setups[1].text, {}, true}}, linuxcnc());
    EXPECT_EQ(again.verdict, plan.verdict);
    ASSERT_EQ(again.rest.size(), plan.rest.size());
    for (std::size_t i = 0; i < plan.rest.size(); ++i) {
        EXPECT_NEAR(again.rest[i].left_mm, plan.rest[i].left_mm, 1e-9);
        EXPECT_NEAR(again.rest[i].z_start_mm, plan.rest[i].z_start_mm, 1e-9);
        EXPECT_EQ(again.rest[i].cause, plan.rest[i].cause);
    }
    for (std::size_t i = 0; i < plan.setups[0].operations.size(); ++i)
        EXPECT_EQ(again.setups[0].operations[i].first_line, plan.setups[0].operations[i].first_line);
}

TEST(PlanPrograms, AWordThatCutsDeeperIsFound)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}));
    ASSERT_FALSE(plan.is_refused);
    const std::string text = changed(plan.setups[0].text, "G1 X29.6");
    const TurningPlan again = withPrograms(plan, {{0, text, {}, true}}, linuxcnc());
    EXPECT_TRUE(again.is_refused);
    EXPECT_EQ(again.verdict, Verdict::Fail);
    EXPECT_GT(again.setups[0].check.gouge_um, 50);
    EXPECT_EQ(again.setups[0].text, text);
}

TEST(PlanPrograms, WhatIsNotCheckedHasNoVerdict)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "linuxcnc", SetupChoice::Two);
    const std::string text = changed(plan.setups[0].text, "G1 X29.6");
    const TurningPlan open = withPrograms(plan, {{0, text, {}, false}}, linuxcnc());
    EXPECT_FALSE(open.verdict);
    EXPECT_TRUE(open.rest.empty());
    for (const SetupPlan& setup : open.setups) {
        EXPECT_FALSE(setup.check.stock);
        EXPECT_TRUE(setup.check.findings.empty());
        EXPECT_FALSE(setup.check.path.moves.empty());
    }
}

TEST(PlanPrograms, AStatedCorrectionIsNoGouge)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}));
    const std::string text = changed(plan.setups[0].text, "G1 X29.96");
    const gcode::StatedCorrection stated{{-5, 97.7, 98.1}, {-0.02, -0.02, 0}};
    EXPECT_GT(withPrograms(plan, {{0, text, {}, true}}, linuxcnc()).setups[0].check.gouge_um, 15);
    EXPECT_LE(withPrograms(plan, {{0, text, stated, true}}, linuxcnc()).setups[0].check.gouge_um, 1.5);
}

TEST(PlanPrograms, AProgramWithErrorsLeavesTheNextOneOpen)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "linuxcnc", SetupChoice::Two);
    const TurningPlan broken =
        withPrograms(plan, {{0, changed(plan.setups[0].text, "G1 X[1/0]"), {}, true}}, linuxcnc());
    EXPECT_FALSE(broken.verdict);
    EXPECT_TRUE(broken.is_refused);
    EXPECT_TRUE(broken.setups[0].check.path.has_errors);
    EXPECT_FALSE(broken.setups[1].check.stock);
    EXPECT_TRUE(broken.rest.empty());
}

TEST(PlanPrograms, AToolThatTheJobLacksIsSaid)
{
    const TurningPlan plan = planned(jobWith({row(30, 20, 20), row(20, 30, 30)}, 32, 90, {roughC80(), finishC80()}));
    ASSERT_FALSE(plan.is_refused);
    std::string text = plan.setups[0].text;
    const std::size_t end = text.rfind("M30");
    ASSERT_NE(end, std::string::npos) << text;
    text.insert(text.rfind('\n', end) + 1, "T77 M6 G43\nG97 S500 M3\nG0 X60. Z5.\nG1 X50. F0.1\nG0 X60.\n");
    const TurningPlan again = withPrograms(plan, {{0, text, {}, true}}, linuxcnc());
    const auto note = std::find_if(again.notes.begin(), again.notes.end(),
                                   [](const Note& each) { return each.code == notes::toolNotInJob; });
    ASSERT_NE(note, again.notes.end());
    EXPECT_EQ(*find(note->values, "tool"), Value(std::int64_t{77}));
    EXPECT_EQ(unknownToolOf(again.setups[0].check), 77);
    EXPECT_NE(again.verdict, Verdict::Pass);
    // Notes of a removed check are removed as well.
    const TurningPlan back = withPrograms(again, {{0, plan.setups[0].text, {}, true}}, linuxcnc());
    EXPECT_FALSE(contains(back.notes, notes::toolNotInJob));
    EXPECT_EQ(back.notes.size(), plan.notes.size());
    EXPECT_EQ(back.verdict, plan.verdict);
}

TEST(PlanPrograms, WithoutAStableSpeedNoOtherTextPasses)
{
    Job job = jobWith({row(98, 30, 30), row(20, 37, 37)}, 40, 200, {roughC80(), finishC80()});
    job.shaft->segments = {row(100, 30, 30)};  // no residual material
    job.max_rpm = 2000;
    TurningInputs inputs = linuxcnc();
    inputs.spindle = receptance::SpindleReceptance{receptance::SpindleSprings{14850, 198.3e6, 0.06}};
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    const TurningPlan plan = planTurning(*job.shaft, job, inputs, parameters);
    ASSERT_TRUE(contains(plan.notes, notes::noStableSpeedHere));
    ASSERT_TRUE(plan.rest.empty() && !plan.is_refused);
    EXPECT_EQ(plan.verdict, Verdict::Fail);
    EXPECT_EQ(withPrograms(plan, {{0, plan.setups[0].text + "\n", {}, true}}, inputs).verdict, Verdict::Fail);
}

TEST(PlanPrograms, OtherTextsAreReadInTheDialectThatTheyLookLike)
{
    const Job job = jobWith({row(30, 20, 20), row(20, 30, 30)}, 32, 90, {roughC80(), finishC80()});
    TurningInputs inputs;
    inputs.post = postNamed("fanuc_b");
    const TurningPlan plan = planned(job, "fanuc_b");
    ASSERT_FALSE(plan.is_refused);
    for (const char* post : {"fanuc_a", "linuxcnc", "sinumerik", "fanuc_b"}) {
        const TurningPlan again = withPrograms(plan, {{0, planned(job, post).setups[0].text, {}, true, false}}, inputs);
        EXPECT_FALSE(again.is_refused) << post;
        EXPECT_LE(again.setups[0].check.gouge_um, 1.5) << post;
        EXPECT_EQ(again.setups[0].check.path.moves.size(), planned(job, post).setups[0].check.path.moves.size())
            << post;
    }
}

TEST(PlanFiles, BothProgramsOrNone)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "linuxcnc", SetupChoice::Two);
    const auto folder = std::filesystem::path(testing::TempDir()) / "lathelier_plan_files";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "p_2.nc");  // a folder stands where the second one belongs
    const std::vector<std::string> paths = programPaths((folder / "p.nc").string(), 2);
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_EQ(paths[0], (folder / "p_1.nc").string());
    EXPECT_THROW(writePrograms(plan, paths), Error);
    EXPECT_FALSE(std::filesystem::exists(paths[0]));
    io::writeFile(paths[0], "before");
    EXPECT_THROW(writePrograms(plan, paths), Error);
    EXPECT_EQ(io::FileBytes(paths[0]).view(), "before");
    std::filesystem::remove_all(folder / "p_2.nc");
    writePrograms(plan, paths);
    EXPECT_EQ(io::FileBytes(paths[0]).view(), plan.setups[0].text);
    EXPECT_EQ(io::FileBytes(paths[1]).view(), plan.setups[1].text);
    EXPECT_THROW(refuseInputs(paths, {{paths[1], 0, ""}}, "--out"), Error);
    EXPECT_NO_THROW(refuseInputs(paths, {{(folder / "job.json").string(), 0, ""}}, "--out"));
    std::filesystem::remove_all(folder);
}

TEST(CorrectionOf, RunsAreLaidOverEachOther)
{
    const std::vector<gcode::CorrectedCorner> corners{{0, 0.01}, {50, 0.03}, {100, 0.02}, {20, -0.01}, {60, -0.02}};
    const gcode::StatedCorrection all = gcode::correctionOf(corners);
    EXPECT_NEAR(all.at_mm(0), 0.01, 1e-12);
    EXPECT_NEAR(all.at_mm(20), -0.01, 1e-12);
    EXPECT_NEAR(all.at_mm(40), -0.015, 1e-12);
    EXPECT_NEAR(all.at_mm(60), -0.02, 1e-12);
    EXPECT_NEAR(all.at_mm(100), 0.02, 1e-12);
}

}  // namespace
}  // namespace lathelier::cam
