// Entering angles below 90°: the face is cut by a tool whose main edge stays off it, or it stays and says so.
#include <gtest/gtest.h>

#include "engine/cam/plan_codes.h"
#include "tests/engine/cam/plan_checks.h"
#include "tests/engine/cam/rapid_checks.h"

namespace lathelier::cam {
namespace {

/// Cones up to the chuck, 2 mm of raw face.
Job coneJob(double rough_deg, double finish_deg)
{
    Job job = jobWith({row(0.5, 12.564, 13.564), row(26.979, 13.564, 13.564), row(9.414, 13.564, 18.603),
                       row(5.282, 18.603, 18.603), row(12.592, 18.603, 22.9), row(10.189, 22.9, 22.9)},
                      31, 85,
                      {insert(1, ToolUse::Rough, 1.2, rough_deg, rough_deg > 90 ? 80 : 90),
                       insert(2, ToolUse::Finish, 0.4, finish_deg, 80)});
    job.stock.face_allowance_mm = 2;
    job.cutting.rough = {1.5, 0.2, 190, 0.6};
    return job;
}

TEST(FacingTool, FinishingToolFacesWhereRoughingCannot)
{
    for (const double entering : {45.0, 75.0, 80.0, 85.0}) {
        const TurningPlan plan = planned(coneJob(entering, 95));
        const std::string what = "entering angle " + std::to_string(entering);
        expectSound(plan, what);
        expectQuietRapids(plan, what);
        EXPECT_LT(plan.left_max_mm, 0.005) << what;
        for (const RestInterval& rest : plan.rest) EXPECT_GT(rest.z_end_mm, 0.5) << what << ": the face is finished";
        ASSERT_FALSE(plan.setups[0].operations.empty());
        EXPECT_EQ(plan.setups[0].operations[0].kind, OperationKind::Face) << what;
        EXPECT_EQ(plan.setups[0].operations[0].tool, 2) << what;
    }
}

TEST(FacingTool, RoughingToolFacesToSizeWhereTheFinishCannot)
{
    const TurningPlan plan = planned(coneJob(95, 75));
    expectSound(plan, "finish of 75 degrees");
    EXPECT_EQ(plan.setups[0].operations[0].tool, 1);
    for (const RestInterval& rest : plan.rest) EXPECT_GT(rest.z_end_mm, 0.01) << "the face is finished";
    EXPECT_EQ(plan.setups[0].text.find("NOT REACHABLE: Z 0.00-0.00"), std::string::npos);
}

TEST(FacingTool, FaceStaysWhereNoToolCan)
{
    const TurningPlan plan = planned(coneJob(75, 75));
    expectSound(plan, "two tools of 75 degrees");
    EXPECT_TRUE(contains(plan.notes, notes::noToolToFace));
    ASSERT_FALSE(plan.rest.empty());
    EXPECT_NEAR(plan.rest[0].z_start_mm, 0, 0.01);
    EXPECT_GT(plan.rest[0].left_mm, 1);
    EXPECT_EQ(plan.verdict, Verdict::Fail);
}

}  // namespace
}  // namespace lathelier::cam
