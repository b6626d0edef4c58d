// Roughing and finish as G71 and G70: residual material, collisions, and conditions for moves instead of cycles.
#include "engine/cam/post/roughing_cycle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

TurningPlan inCycles(const Job& job, Post post, CycleChoice cycles = CycleChoice::Cycles)
{
    TurningInputs inputs;
    inputs.post = std::move(post);
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    parameters.cycles = cycles;
    return planTurning(*job.shaft, job, inputs, parameters);
}

Job jobNamed(const std::string& name)
{
    for (const Practice& practice : practiceJobs())
        if (practice.name == name) return practice.job;
    return {};
}

std::size_t countOf(const std::string& text, const std::string& word)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
}

bool isRemarked(const TurningPlan& plan)
{
    return std::any_of(plan.notes.begin(), plan.notes.end(),
                       [](const Note& note) { return note.code == notes::cycleNotPossible; });
}

TEST(RoughingCycle, LeavesWhatMovesLeave)
{
    for (const char* const name : {"contour", "paper_s1", "paper_s2"})
        for (const char* const post : {"fanuc_a", "fanuc_b", "haas"}) {
            const std::string what = std::string(name) + " " + post;
            const Job job = jobNamed(name);
            const TurningPlan moves = planned(job, post), cycles = inCycles(job, postNamed(post));
            expectSound(cycles, what);
            EXPECT_FALSE(isRemarked(cycles)) << what;
            const std::string& text = cycles.setups[0].text;
            EXPECT_EQ(countOf(text, "G71 P"), 1U) << what;
            EXPECT_EQ(countOf(text, "G70 P"), 1U) << what;
            ASSERT_EQ(cycles.rest.size(), moves.rest.size()) << what;
            for (std::size_t i = 0; i < moves.rest.size(); ++i) {
                EXPECT_NEAR(cycles.rest[i].left_mm, moves.rest[i].left_mm, 0.002) << what;
                EXPECT_NEAR(cycles.rest[i].z_start_mm, moves.rest[i].z_start_mm, 0.05) << what;
            }
            // Finishing has the same path and speeds.
            const auto finish_of = [](const TurningPlan& plan) {
                const auto& all = plan.setups[0].operations;
                return *std::find_if(all.begin(), all.end(),
                                     [](const PlannedOperation& o) { return o.kind == OperationKind::Finish; });
            };
            const PlannedOperation a = finish_of(moves), b = finish_of(cycles);
            EXPECT_NEAR(b.feed_length_mm, a.feed_length_mm, 0.05 * a.feed_length_mm + 3) << what;
            EXPECT_NEAR(b.time_s, a.time_s, 0.05 * a.time_s + 1) << what;
            EXPECT_GT(b.contour_last_line, b.contour_first_line) << what;
        }
}

TEST(RoughingCycle, PassesAreEqualAndNoDeeperThanAsked)
{
    const Job job = jobNamed("paper_s1");
    const TurningPlan plan = inCycles(job, postNamed("fanuc_a"));
    std::vector<double> levels;
    const std::vector<gcode::Move>& moves = plan.setups[0].check.path.moves;
    for (std::size_t i = 1; i < moves.size(); ++i)
        if (moves[i].tool == 1 && moves[i].kind == gcode::MoveKind::Feed && moves[i].x_mm == moves[i - 1].x_mm &&
            moves[i - 1].z_mm - moves[i].z_mm > 50)
            levels.push_back(moves[i].x_mm);
    // Two passes from 0.5 mm above the bar, then along the contour.
    ASSERT_EQ(levels.size(), 3U);
    const double step = 20.5 - levels[0];
    EXPECT_LE(step, job.cutting.rough.depth_mm + 1e-9);
    EXPECT_NEAR(levels[0] - levels[1], step, 1e-3);
    EXPECT_LT(levels[1] - levels[2], step + 1e-3);
    EXPECT_NEAR(levels[2], 15 + job.cutting.rough.allowance_mm, 0.002);
}

TEST(RoughingCycle, AContourThatFallsStaysMoves)
{
    const Job job = jobNamed("paper_c80");
    const TurningPlan cycles = inCycles(job, postNamed("fanuc_a")), moves = planned(job, "fanuc_a");
    EXPECT_TRUE(isRemarked(cycles));
    EXPECT_EQ(cycles.setups[0].text, moves.setups[0].text);
    EXPECT_FALSE(isRemarked(moves));
}

TEST(RoughingCycle, AControlWithoutCyclesIsRefused)
{
    for (const char* const post : {"linuxcnc", "sinumerik", "grbl"}) try {
            inCycles(jobNamed("paper_s1"), postNamed(post));
            ADD_FAILURE() << post;
        } catch (const Error& error) {
            EXPECT_TRUE(error.code() == errors::postCannot) << post;
        }
}

TEST(RoughingCycle, ThePostAsksForIt)
{
    std::string text = postText(postNamed("fanuc_a"));
    text.replace(text.find("\"cycles\": \"none\""), 16, "\"cycles\": \"g71_g70\"");
    Notes remarks;
    const Post post = readPost(text, remarks);
    EXPECT_TRUE(remarks.empty());
    EXPECT_TRUE(post.cycles);
    EXPECT_EQ(readPost(postText(post), remarks), post);
    const Job job = jobNamed("paper_s1");
    EXPECT_EQ(countOf(inCycles(job, post, CycleChoice::AsPost).setups[0].text, "G71"), 2U);
    EXPECT_EQ(countOf(inCycles(job, post, CycleChoice::Moves).setups[0].text, "G71"), 0U);
}

TEST(RoughingCycle, WithoutACycleOfTheFinishItIsMoves)
{
    Post post = postNamed("fanuc_a");
    post.finish_cycle.clear();
    const TurningPlan plan = inCycles(jobNamed("paper_s1"), post);
    expectSound(plan, "no G70");
    EXPECT_EQ(countOf(plan.setups[0].text, "G71 P"), 1U);
    EXPECT_EQ(plan.setups[0].operations.back().contour_first_line, 0);
}

TEST(RoughingCycle, WithoutBlockNumbersBothEndsOfTheContourAreNumbered)
{
    Post post = postNamed("fanuc_a");
    post.block_numbers.reset();
    const TurningPlan plan = inCycles(jobNamed("paper_s1"), post);
    expectSound(plan, "no numbers");
    const std::string& text = plan.setups[0].text;
    EXPECT_NE(text.find("G71 P1 Q2 "), std::string::npos);
    EXPECT_EQ(countOf(text, "\nN"), 2U);
    EXPECT_NE(text.find("\nN1 G0 X"), std::string::npos);
}

TEST(RoughingCycle, UnchangedWordsAreRepeatedWithoutHarm)
{
    Post post = postNamed("fanuc_a");
    post.modal = false;
    const TurningPlan plan = inCycles(jobNamed("contour"), post);
    expectSound(plan, "not modal");
    EXPECT_EQ(countOf(plan.setups[0].text, "G70 P"), 1U);
}

TEST(RoughingCycle, RandomContoursThatRise)
{
    std::mt19937 random(15);
    int cycles = 0;
    for (int i = 0; i < 60; ++i) {
        Shaft shaft = randomShaft(random);
        std::sort(shaft.segments.begin(), shaft.segments.end(), [](const ShaftSegment& a, const ShaftSegment& b) {
            return a.start_diameter_mm + a.end_diameter_mm < b.start_diameter_mm + b.end_diameter_mm;
        });
        double diameter = 0, length = 0;
        for (ShaftSegment& segment : shaft.segments) {
            segment.arc_radius_mm.reset();
            segment.start_diameter_mm = std::max(segment.start_diameter_mm, diameter);
            segment.end_diameter_mm = std::max(segment.end_diameter_mm, segment.start_diameter_mm);
            diameter = segment.end_diameter_mm;
            length += segment.length_mm;
        }
        const Job job = jobWith(shaft.segments, diameter + 4, length + 30, {roughC80(), finishD55()});
        const TurningPlan plan = inCycles(job, postNamed("fanuc_a"));
        expectSound(plan, "random " + std::to_string(i));
        cycles += isRemarked(plan) ? 0 : 1;
    }
    EXPECT_GE(cycles, 50);
}

}  // namespace
}  // namespace lathelier::cam
