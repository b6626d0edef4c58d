// Tools are changed away from the work, and approaches in grooves make no move for nothing.
#include <gtest/gtest.h>

#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/cam_data.h"
#include "tests/engine/cam/plan_checks.h"
#include "tests/engine/cam/rapid_checks.h"

namespace lathelier::cam {
namespace {

/// Changes tools where the last operation ended, as a program without a change point does.
Post postWithoutChangePoint()
{
    Post post = postNamed("linuxcnc");
    post.tool_start = {"T{tool} M6 G43"};
    return post;
}

TurningPlan plannedWith(const Job& job, const Post& post)
{
    TurningInputs inputs;
    inputs.post = post;
    TurningParameters parameters;
    parameters.setups = SetupChoice::One;
    return planTurning(*job.shaft, job, inputs, parameters);
}

/// With a valley at its end, which the opposite hand reaches beside the chuck.
Job closeToChuck()
{
    Job job =
        jobWith({row(10.131, 15.749, 15.749), row(11.02, 15.749, 18.885), row(11.926, 16.602, 16.602),
                 row(4.497, 16.602, 16.602), row(5.791, 18.57, 18.57)},
                22, 51.365, {roughC80(), finishC80(), insert(3, ToolUse::FinishBack, 0.4, 93, 35, Hand::FromChuck)});
    job.tools.back().edge_length_mm = 16;
    job.stock.face_allowance_mm = 2;
    job.cutting.rough = {2, 0.2, 190, 0.6};
    return job;
}

TEST(ChangePoint, EveryPostLeavesTheWorkFirst)
{
    for (const std::string& post : postNames())
        for (const Job& job : {practiceJobs()[2].job, tailstockJob()}) {
            const TurningPlan plan = planned(job, post.c_str());
            expectSound(plan, post);
            EXPECT_FALSE(contains(plan.notes, notes::toolChangeNearWork)) << post;
            const std::vector<gcode::Move>& moves = plan.setups[0].check.path.moves;
            for (std::size_t i = 1; i < moves.size(); ++i)
                if (moves[i].tool != moves[i - 1].tool) {
                    EXPECT_FALSE(gcode::isKnown(moves[i - 1].x_mm) || gcode::isKnown(moves[i - 1].z_mm))
                        << post << " line " << moves[i].line;
                }
            EXPECT_FALSE(gcode::isKnown(moves.back().x_mm)) << post << ": the program ends at the change point";
        }
}

TEST(ChangePoint, SpindleStandsWhereTheOperatorChanges)
{
    for (const char* post : {"linuxcnc", "grbl"}) {
        const std::string text = planned(practiceJobs()[2].job, post).setups[0].text;
        std::size_t changes = 0;
        for (std::size_t at = text.find("\nT"); at != std::string::npos; at = text.find("\nT", at + 1)) {
            ++changes;
            const std::size_t stop = text.rfind("\nM5\n", at), start = text.rfind(" M3\n", at);
            EXPECT_NE(stop, std::string::npos);
            EXPECT_TRUE(start == std::string::npos || stop > start) << text.substr(0, at);
        }
        EXPECT_GE(changes, 3U) << post;
    }
}

TEST(ChangePoint, CheckSeesAChangeBesideTheWork)
{
    const Job job = practiceJobs()[0].job;
    const TurningPlan plan = plannedWith(job, postWithoutChangePoint());
    bool is_seen = false;
    for (const Note& note : plan.notes)
        if (note.code == notes::toolChangeNearWork) {
            is_seen = true;
            EXPECT_NEAR(std::get<double>(*find(note.values, "distance_mm")), 2, 0.5);
            EXPECT_EQ(std::get<std::int64_t>(*find(note.values, "tool")), 2);
        }
    EXPECT_TRUE(is_seen);
}

TEST(ChangePoint, OperationThatMeetsTheChuckIsDroppedAlone)
{
    // The tool is called beside the chuck and meets it on its way: only the check of the whole program sees that.
    const TurningPlan plan = plannedWith(closeToChuck(), postWithoutChangePoint());
    expectSound(plan, "close to the chuck");
    EXPECT_TRUE(contains(plan.notes, notes::restCannot));
    for (const PlannedOperation& operation : plan.setups[0].operations)
        EXPECT_NE(operation.kind, OperationKind::FinishBack);
    bool is_listed = false;
    for (const RestInterval& rest : plan.rest) is_listed = is_listed || rest.cause == RestCause::Chuck;
    EXPECT_TRUE(is_listed);
    EXPECT_EQ(plan.verdict, Verdict::Fail);
    // With a change point the same operation is sound.
    const TurningPlan usual = planned(closeToChuck());
    expectSound(usual, "change point");
    EXPECT_LT(usual.left_max_mm, plan.left_max_mm);
}

TEST(ChangePoint, GroovesAreEnteredOnceAndClear)
{
    Notes notes;
    const Job job = readJob(textOf("groove_dip_job.json"), notes);
    for (const char* post : {"linuxcnc", "fanuc_a"}) {
        const TurningPlan plan = planned(job, post);
        expectSound(plan, post);
        expectQuietRapids(plan, post);
        EXPECT_NEAR(plan.left_max_mm, 0.1657, 0.002);
    }
}

}  // namespace
}  // namespace lathelier::cam
