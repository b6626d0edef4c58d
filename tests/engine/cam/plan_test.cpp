// Plans: written, read again and checked; what stays is what the curves say.
#include "engine/cam/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {
namespace {

struct Expected {
    double from, to, left;
};

void expectRest(const TurningPlan& plan, const std::vector<Expected>& expected, const std::string& what)
{
    std::vector<RestInterval> rest;
    for (const RestInterval& found : plan.rest)
        if (found.left_mm > 0.005) rest.push_back(found);
    ASSERT_EQ(rest.size(), expected.size()) << what;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        EXPECT_NEAR(rest[i].z_start_mm, expected[i].from, 0.05) << what;
        EXPECT_NEAR(rest[i].z_end_mm, expected[i].to, 0.05) << what;
        EXPECT_NEAR(rest[i].left_mm, expected[i].left, 0.002) << what;
    }
}

void expectSound(const TurningPlan& plan, const std::string& what)
{
    EXPECT_FALSE(plan.is_refused) << what;
    for (const SetupPlan& setup : plan.setups) {
        EXPECT_FALSE(setup.check.path.has_errors) << what;
        EXPECT_LE(setup.check.gouge_um, 1.5) << what;
        for (const CheckFinding& finding : setup.check.findings)
            ADD_FAILURE() << what << " line " << finding.line << " " << key(finding.kind) << " z " << finding.z_mm
                          << " " << finding.depth_mm << "\n"
                          << setup.text;
    }
}

struct Practice {
    const char* name;
    Job job;
    std::vector<Expected> rest;
};

std::vector<Practice> practiceJobs()
{
    Job contour = jobWith({row(1, 18, 20), row(17, 20, 20), row(2, 20, 24, -2), row(3, 30, 36, 3), row(7, 36, 36),
                           row(4, 36, 44, -4), row(6, 44, 50), row(20, 50, 50)},
                          54, 90, {roughC80(), finishC80()});
    Job ball = jobWith({row(10, 0.001, 20, 10), row(8, 16, 16), row(6, 16, 28, 9), row(30, 28, 28)}, 30, 90,
                       {roughC80(), finishD55()});
    Job neck =
        jobWith(neckRows(), 32, 150, {roughD55(), finishD55(), backV35(), blade(8, ToolUse::Groove, 2, 0.2, 18)});
    neck.part_off = true;
    Job first = jobWith({row(98, 30, 30), row(6, 37, 37)}, 40, 130, {roughC80(), finishC80()});
    first.sections = {{98, 2154}, {104, 1750}};
    return {
        {"contour", contour, {}},
        {"ball", ball, {{10, 13.52, 1.7321}, {17.76, 18.07, 0.0952}}},
        {"neck_all", neck, {{27, 27.16, 0.0828}, {29.84, 30, 0.0828}, {88.99, 89.02, 0.0052}, {96.97, 97.03, 0.0126}}},
        {"neck_c80",
         jobWith(neckRows(), 32, 150, {roughC80(), finishC80()}),
         {{27, 30, 1.498}, {77.01, 100.41, 3.3666}}},
        {"neck_d55",
         jobWith(neckRows(), 32, 150, {roughD55(), finishD55()}),
         {{27, 30, 1.2991}, {88.99, 89.02, 0.0052}, {96.91, 97.07, 0.0255}}},
        {"paper_c80",
         paperJob({roughC80(), finishC80()}),
         {{97.65, 98, 0.1657}, {108, 138.47, 1.5979}, {178, 183, 4.7385}}},
        {"paper_v35",
         paperJob({roughD55(), finishV35()}),
         {{97.65, 98, 0.1657}, {108, 109.47, 1.0283}, {182.76, 183, 0.1657}}},
        {"paper_s1", first, {{97.65, 98, 0.1657}}},
        {"paper_s2",
         jobWith({row(5, 23.8, 33.8), row(70, 33.8, 33.8), row(4.2, 37, 37)}, 40, 90, {roughC80(), finishC80()}),
         {{74.65, 75, 0.1657}}}};
}

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
                if (gcode::isKnown(move.x_mm) && gcode::isKnown(move.z_mm) && !move.passes_point) to.push_back(move);
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
    // The shoulder keeps the finishing nose; groove and end keep the blade's corner at most.
    ASSERT_FALSE(plan.rest.empty());
    EXPECT_NEAR(plan.rest[0].left_mm, 0.1657, 0.002);
    for (const RestInterval& rest : plan.rest) EXPECT_LE(rest.left_mm, 0.1677);
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
        // Rounding moves what is left by up to 2 µm, and with it what is large enough to be listed.
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
