// Plans: written, read again and checked; residual material equals that predicted from the curves.
#include "engine/cam/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

TEST(TurningPlan, PracticeJobsWithAllPosts)
{
    for (const Practice& practice : practiceJobs())
        for (const std::string& post : postNames()) {
            const TurningPlan plan = planned(practice.job, post.c_str());
            const std::string what = std::string(practice.name) + " " + post;
            expectSound(plan, what);
            expectRest(plan, practice.rest, what);
        }
}

TEST(TurningPlan, AllPostsMakeTheSameMoves)
{
    const Job job = practiceJobs()[2].job;
    const TurningPlan plan = planned(job, "linuxcnc");
    for (const std::string& post : postNames()) {
        const TurningPlan other = planned(job, post.c_str());
        std::vector<gcode::Move> a, b;
        const auto known = [](const std::vector<gcode::Move>& moves, std::vector<gcode::Move>& to) {
            for (const gcode::Move& move : moves)
                if (move.kind == gcode::MoveKind::Feed || move.kind == gcode::MoveKind::Arc) to.push_back(move);
        };
        known(plan.setups[0].check.path.moves, a);
        known(other.setups[0].check.path.moves, b);
        // A radius with four decimals keeps short moves that three on the diameter lose.
        if (post == "grbl") continue;
        ASSERT_EQ(a.size(), b.size()) << post;
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_NEAR(a[i].x_mm, b[i].x_mm, 0.001) << post;
            EXPECT_NEAR(a[i].z_mm, b[i].z_mm, 0.001) << post;
        }
    }
}

TEST(TurningPlan, RestToolsLeaveLess)
{
    Job job = paperJob({roughD55(), finishV35(), backV35(), blade(8, ToolUse::Groove, 3, 0.2, 22)}, true);
    const TurningPlan plan = planned(job);
    expectSound(plan, "paper all");
    // The shoulder retains the radius of the finishing nose; the foot behind the collar and the end at most that of the
    // blade corner.
    ASSERT_GE(plan.rest.size(), 2U);
    EXPECT_NEAR(plan.rest[0].left_mm, 0.1657, 0.002);
    EXPECT_NEAR(plan.rest[1].z_start_mm, 108, 0.05);
    EXPECT_NEAR(plan.rest[1].left_mm, 0.0828, 0.002);
    for (std::size_t i = 2; i < plan.rest.size(); ++i) EXPECT_LE(plan.rest[i].left_mm, 0.0232);
}

TEST(TurningPlan, PaperShaftIsTurnedRound)
{
    const TurningPlan plan = planned(paperJob({roughC80(), finishC80()}), "fanuc_a", SetupChoice::Auto);
    ASSERT_EQ(plan.setups.size(), 2U);
    expectSound(plan, "paper, two clampings");
    ASSERT_EQ(plan.rest.size(), 2U);
    EXPECT_NEAR(plan.rest[0].left_mm, 0.1657, 0.002);
    EXPECT_NEAR(plan.rest[1].left_mm, 0.1657, 0.002);
    EXPECT_NEAR(plan.rest[0].z_end_mm, 98, 0.01);
    EXPECT_NEAR(plan.rest[1].z_start_mm, 108, 0.01);
}

TEST(TurningPlan, OneClampingWhereTwoAreNoBetter)
{
    const TurningPlan plan =
        planned(jobWith(neckRows(), 32, 150, {roughC80(), finishC80()}), "fanuc_a", SetupChoice::Auto);
    EXPECT_EQ(plan.setups.size(), 1U);
}

TEST(TurningPlan, RandomShaftsLeaveWhatTheCurvesSay)
{
    const char* soak = std::getenv("LATHELIER_SOAK");
    const int count = soak ? std::atoi(soak) : 100;
    for (int i = 0; i < count; ++i) {
        std::mt19937 random(static_cast<unsigned>(1000 + i));
        const Job job = randomJob(random, i % 2 == 1);
        const std::string what = "shaft " + std::to_string(i);
        const TurningPlan plan = planned(job, i % 3 == 0 ? "fanuc_a" : "linuxcnc");
        expectSound(plan, what);
        if (i % 2 == 1) continue;
        const SetupPlan& setup = plan.setups[0];
        // Rounding changes residuals by up to 2 µm, and so the list of those above the limit.
        constexpr double rounding_mm = 0.002;
        for (const Unreached& unreached : setup.predicted) {
            if (unreached.left_mm <= leastRest_mm + rounding_mm) continue;
            double nearest = 1e9;
            for (const RestInterval& found : setup.check.rest)
                if (found.z_start_mm <= unreached.z_most_mm + 0.05 && found.z_end_mm >= unreached.z_most_mm - 0.05)
                    nearest = std::min(nearest, std::abs(found.left_mm - unreached.left_mm));
            EXPECT_LT(nearest, rounding_mm) << what << " z " << unreached.z_most_mm;
        }
        for (const RestInterval& found : setup.check.rest) {
            if (found.left_mm <= leastRest_mm + rounding_mm) continue;
            double nearest = 1e9;
            for (const Unreached& unreached : setup.predicted)
                if (unreached.z_start_mm <= found.z_end_mm + 0.05 && unreached.z_end_mm >= found.z_start_mm - 0.05)
                    nearest = std::min(nearest, std::abs(found.left_mm - unreached.left_mm));
            EXPECT_LT(nearest, rounding_mm) << what << " z " << found.z_start_mm;
        }
    }
}

TEST(TurningPlan, RandomShaftsWithRestToolsLeaveNoMore)
{
    for (int i = 0; i < 10; ++i) {
        std::mt19937 random(static_cast<unsigned>(5000 + i));
        Job job = randomJob(random, true);
        const TurningPlan all = planned(job);
        job.tools.resize(2);
        job.part_off = false;
        const TurningPlan profile = planned(job);
        EXPECT_LE(all.left_max_mm, profile.left_max_mm + 0.002) << i;
    }
}

TEST(TurningPlan, RefusesWhatCannotBe)
{
    const auto codeOf = [](const Job& job) -> std::string {
        try {
            planned(job);
            return "";
        } catch (const Error& error) {
            return error.code().key;
        }
    };
    Job job = paperJob({roughC80(), finishC80()});
    job.stock.diameter_mm = 36;
    EXPECT_EQ(codeOf(job), "stock_smaller_than_part");
    job = paperJob({roughC80(), finishC80()});
    job.setup.chuck_face_z_mm = 150;
    job.stock.length_mm = 230;
    EXPECT_EQ(codeOf(job), "no_setup_possible");
    job = paperJob({roughC80()});
    EXPECT_EQ(codeOf(job).substr(0, 5), "tool_");
    job = paperJob({roughC80(), finishC80()});
    job.cutting.finish.feed_mm_rev = 0.9;
    EXPECT_EQ(codeOf(job), "tool_feed_beyond_nose");
    job = paperJob({roughC80(), finishC80(), blade(8, ToolUse::Groove, 3, 0.2, 12)}, true);
    EXPECT_EQ(codeOf(job).substr(0, 5), "tool_");
}

}  // namespace
}  // namespace lathelier::cam
