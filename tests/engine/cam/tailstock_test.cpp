// Work between chuck and tailstock: allowed tool positions, engagement of the tailstock, residual material on the face.
#include "engine/cam/tailstock.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/cam_data.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

TEST(Tailstock, AllPostsGiveASoundProgram)
{
    for (const std::string& post : postNames()) {
        const TurningPlan plan = planned(tailstockJob(), post.c_str());
        expectSound(plan, post);
        EXPECT_TRUE(plan.rest.empty() || plan.rest.front().cause == RestCause::NoseRadius) << post;
        const SetupPlan& setup = plan.setups[0];
        ASSERT_GE(setup.operations.size(), 4U) << post;
        EXPECT_EQ(setup.operations[0].kind, OperationKind::Face) << post;
        EXPECT_EQ(setup.operations[1].kind, OperationKind::CentreDrill) << post;
        // The stop is between the last block of the drill and the first of the next tool.
        const std::size_t stop = setup.text.find("BRING THE TAILSTOCK");
        ASSERT_NE(stop, std::string::npos) << post;
        EXPECT_GT(stop, setup.text.find("CENTRE DRILL")) << post;
        EXPECT_NE(setup.text.find("M0", stop), std::string::npos) << post;
    }
}

TEST(Tailstock, NothingFacesTheEndAfterItsHole)
{
    const TurningPlan plan = planned(tailstockJob(), "fanuc_a");
    bool is_drilled = false;
    for (const Operation& operation : plan.setups[0].moves) {
        if (is_drilled)
            for (const CutMove& move : operation.moves) {
                // No tip comes below the first diameter at the face.
                const bool is_at_face = move.to.x() < 1e-6;
                if (is_at_face) {
                    EXPECT_GT(move.to.y(), 11.5) << key(operation.kind);
                }
            }
        is_drilled = is_drilled || operation.kind == OperationKind::CentreDrill;
    }
    EXPECT_TRUE(is_drilled);
    // X is retracted before Z.
    EXPECT_NE(plan.setups[0].text.find("G28 U0.\nN"), std::string::npos);
    EXPECT_EQ(plan.setups[0].text.find("G28 U0. W0."), std::string::npos);
}

TEST(Tailstock, StandingFromTheStartItKeepsARingOnTheFace)
{
    Job job = tailstockJob();
    job.tools.pop_back();
    for (const std::string& post : postNames()) {
        const TurningPlan plan = planned(job, post.c_str());
        expectSound(plan, post);
        ASSERT_FALSE(plan.rest.empty()) << post;
        EXPECT_NEAR(plan.rest.front().z_start_mm, 0, 1e-6) << post;
        EXPECT_EQ(plan.rest.front().cause, RestCause::Tailstock) << post;
        EXPECT_NEAR(plan.rest.front().left_mm, 1, 0.05) << post;
    }
}

TEST(Tailstock, StatedOutlineIsKeptClearOf)
{
    Job job = tailstockJob();
    for (const double radius : {6.0, 10.0, 13.0}) {
        job.setup.tailstock = JobTailstock{5, {{-0.5, radius}, {-4, radius}, {-30, 25}}};
        for (const bool drill : {true, false}) {
            Job with = job;
            if (!drill) with.tools.pop_back();
            const TurningPlan plan = planned(with, "sinumerik");
            expectSound(plan, std::to_string(radius) + (drill ? " drill" : ""));
        }
    }
    // If the outline covers the whole bar, the end is not faced.
    job.setup.tailstock = JobTailstock{5, {{-2, 30}, {-40, 30}}};
    job.tools.pop_back();
    const TurningPlan plan = planned(job, "fanuc_a");
    expectSound(plan, "wide");
    EXPECT_TRUE(contains(plan.notes, notes::faceNotReached));
    ASSERT_FALSE(plan.rest.empty());
    EXPECT_EQ(plan.rest.front().cause, RestCause::Tailstock);
}

TEST(Tailstock, CheckFindsAMoveIntoItOnlyAfterItCame)
{
    const Job job = tailstockJob();
    const TurningPlan plan = planned(job, "fanuc_a");
    const std::string& text = plan.setups[0].text;
    // Finishing goes down to X4 before the face: into the centre.
    const std::size_t finish = text.find("(FINISH)"), down = text.find("\nN", text.find(" X", text.find(" Z", finish)));
    ASSERT_NE(down, std::string::npos);
    std::string wrong = text;
    wrong.insert(down, "\nG0 X3.");
    const std::int64_t line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(down) + 1, '\n');
    const CheckResult result = checkTurning(wrong, *job.shaft, job);
    bool is_found = false;
    for (const CheckFinding& finding : result.findings)
        is_found = is_found || (finding.kind == CheckKind::Tailstock && std::abs(finding.line - line) <= 1);
    EXPECT_TRUE(is_found);
    // The drill works in the region of the later tailstock.
    EXPECT_TRUE(checkTurning(text, *job.shaft, job).findings.empty());
}

TEST(Tailstock, WhatItKeepsAToolFromIsPredictedWithItsCause)
{
    // The holder collides with the tailstock before the tip reaches the first rows.
    Job job = tailstockJob();
    job.shaft->segments = {row(39, 28, 28), row(40, 34, 34), row(60, 42, 42)};
    job.tools = {roughD55(), finishD55(), centreDrill(9)};
    for (JobTool& tool : job.tools)
        if (!tool.isDrill()) tool.holder = {{-7, 14}, {-14, 8}, {-32, 22}, {-32, 150}, {-7, 150}};
    job.setup.tailstock->keep_out = {{-1, 4}, {-8, 9}, {-8.5, 26}, {-60, 26}};
    const TurningPlan plan = planned(job, "fanuc_a");
    expectSound(plan, "body of the tailstock");
    const auto& predicted = plan.setups[0].predicted;
    const auto beside = [](double from, double to) { return from < 5 && to > 0.1; };
    EXPECT_TRUE(std::any_of(predicted.begin(), predicted.end(), [&](const Unreached& rest) {
        return rest.cause == RestCause::Tailstock && beside(rest.z_start_mm, rest.z_end_mm);
    }));
    bool is_left = false;
    for (const RestInterval& rest : plan.rest) {
        if (!beside(rest.z_start_mm, rest.z_end_mm)) continue;
        is_left = true;
        EXPECT_EQ(rest.cause, RestCause::Tailstock) << rest.z_start_mm << ' ' << rest.z_end_mm << ' ' << rest.left_mm;
    }
    EXPECT_TRUE(is_left);
}

TEST(Tailstock, WithTwoClampingsTheRingOnTheFirstFaceIsStillListed)
{
    Job job = tailstockJob();
    job.tools.pop_back();  // no drill: engaged from the start
    job.shaft->segments = {row(40, 28, 28), row(40, 42, 42), row(50, 34, 34)};
    const TurningPlan plan = planned(job, "fanuc_a", SetupChoice::Two);
    ASSERT_EQ(plan.setups.size(), 2U);
    ASSERT_FALSE(plan.rest.empty());
    EXPECT_LT(plan.rest.front().z_end_mm, 0.02);
    EXPECT_EQ(plan.rest.front().cause, RestCause::Tailstock);
    EXPECT_GT(plan.left_max_mm, 0.5);
    EXPECT_EQ(plan.verdict, Verdict::Fail);
}

TEST(Tailstock, PartingOffIsLeftOut)
{
    Job job = tailstockJob();
    job.part_off = true;
    job.tools.push_back(blade(8, ToolUse::PartOff, 3, 0.2, 30));
    const TurningPlan plan = planned(job, "haas");
    expectSound(plan, "part off");
    EXPECT_TRUE(contains(plan.notes, notes::partOffLeftOut));
    for (const PlannedOperation& operation : plan.setups[0].operations)
        EXPECT_NE(operation.kind, OperationKind::PartOff);
}

TEST(Tailstock, HoldersKeepClearToo)
{
    Job job = tailstockJob();
    for (JobTool& tool : job.tools)
        if (!tool.isDrill()) tool.holder = {{-7, 14}, {-14, 3}, {-32, 22}, {-32, 150}, {-7, 150}};
    for (const bool drill : {true, false}) {
        Job with = job;
        if (!drill) with.tools.pop_back();
        expectSound(planned(with, "linuxcnc"), "holder");
    }
}

TEST(Tailstock, RandomShaftsBetweenCentres)
{
    for (int i = 0; i < 60; ++i) {
        std::mt19937 random(static_cast<unsigned>(9000 + i));
        Job job = randomJob(random, i % 2 == 1);
        job.part_off = false;
        job.setup.tailstock = JobTailstock{4, {}};
        if (i % 3 == 1) job.setup.tailstock->keep_out = {{-1, 4}, {-12, 9}, {-12.5, 20}, {-60, 20}};
        if (i % 2 == 0) job.tools.push_back(centreDrill(9));
        expectSound(planned(job, i % 4 < 2 ? "fanuc_a" : "grbl"), "shaft " + std::to_string(i));
    }
}

}  // namespace
}  // namespace lathelier::cam
