// What a drawing shows besides the turned outside: no program that does not make it is "as drawn".
#include <gtest/gtest.h>

#include "engine/cam/cam_codes.h"
#include "engine/cam/check/check_report.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/plan_quantities.h"
#include "engine/cam/plan_report.h"
#include "tests/engine/cam/cam_data.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

Job plainJob()
{
    return jobWith({row(50, 40, 40)}, 44, 70, {roughC80(), finishC80()});
}

Job boredJob()
{
    Job job = plainJob();
    job.shaft->segments[0].bore_diameter_mm = 20;
    return job;
}

Job keyedJob()
{
    Job job = plainJob();
    ShaftMark keyway;
    keyway.kind = MarkKind::Keyway;
    keyway.z_start_mm = 10;
    keyway.z_end_mm = 30;
    job.shaft->marks.push_back(keyway);
    ShaftMark hole;
    hole.kind = MarkKind::CrossHole;
    hole.diameter_mm = 6;
    hole.z_start_mm = hole.z_end_mm = 40;
    job.shaft->marks.push_back(hole);
    return job;
}

std::string keyOf(const Text& text)
{
    return text.english;
}

TEST(NotMade, PlainPartIsAsDrawn)
{
    const TurningPlan plan = planned(plainJob());
    EXPECT_EQ(plan.verdict, Verdict::Pass);
    EXPECT_TRUE(plan.not_made.empty());
    EXPECT_EQ(plan.setups[0].text.find("NOT IN THE PROGRAM"), std::string::npos);
    const CheckResult check = checked(plan.setups[0].text, plainJob());
    EXPECT_EQ(check.verdict, Verdict::Pass);
}

TEST(NotMade, BoreOfTheSegmentsIsSaidEverywhere)
{
    const TurningPlan plan = planned(boredJob());
    expectSound(plan, "bore");
    EXPECT_EQ(plan.verdict, Verdict::Fail);
    ASSERT_EQ(plan.not_made.size(), 1U);
    EXPECT_EQ(plan.not_made[0].kind, MarkKind::Bore);
    EXPECT_EQ(plan.not_made[0].diameter_mm, 20);
    EXPECT_EQ(plan.not_made[0].z_start_mm, 0);
    EXPECT_EQ(plan.not_made[0].z_end_mm, 50);
    EXPECT_TRUE(contains(plan.notes, notes::boreNotPlanned));
    EXPECT_FALSE(contains(plan.notes, notes::drawnNotChecked));
    EXPECT_NE(plan.setups[0].text.find("NOT IN THE PROGRAM: BORE D20 Z 0-50"), std::string::npos);
    EXPECT_EQ(keyOf(answer(plan).verdict_words), "✗ not all that is drawn is made");
    EXPECT_NE(keyOf(answer(plan).sentence).find("not in the program"), std::string::npos);
    EXPECT_EQ(std::get<Rows>(quantityOf<TurningPlan>("not_made").get(plan)).rows.size(), 1U);
}

TEST(NotMade, BoreOfTheListFromTheOtherEnd)
{
    Job job = plainJob();
    job.shaft->bores.push_back({ShaftEnd::Chuck, {{12, 16, 16, {}, ""}, {4, 10, 10, {}, ""}}});
    const TurningPlan plan = planned(job);
    ASSERT_EQ(plan.not_made.size(), 1U);
    EXPECT_NEAR(plan.not_made[0].z_start_mm.value(), 34, 1e-9);
    EXPECT_NEAR(plan.not_made[0].z_end_mm.value(), 50, 1e-9);
    EXPECT_EQ(plan.not_made[0].diameter_mm, 16);
    EXPECT_EQ(plan.verdict, Verdict::Fail);
}

TEST(NotMade, MarksAreSaid)
{
    const TurningPlan plan = planned(keyedJob(), "fanuc_a");
    EXPECT_EQ(plan.verdict, Verdict::Fail);
    EXPECT_EQ(plan.not_made.size(), 2U);
    EXPECT_TRUE(contains(plan.notes, notes::featureNotPlanned));
    EXPECT_NE(plan.setups[0].text.find("NOT IN THE PROGRAM: KEYWAY Z 10-30"), std::string::npos);
    EXPECT_NE(plan.setups[0].text.find("NOT IN THE PROGRAM: CROSS HOLE D6 Z 40-40"), std::string::npos);
}

TEST(NotMade, ThreadIsMadeByItsOperationAlone)
{
    EXPECT_TRUE(planned(threadedJob()).not_made.empty());
    Job job = threadedJob();
    job.tools.pop_back();
    const TurningPlan plan = planned(job);
    ASSERT_EQ(plan.not_made.size(), 1U);
    EXPECT_EQ(plan.not_made[0].designation, "M24x2");
    EXPECT_NE(plan.verdict, Verdict::Pass);
}

TEST(NotMade, CheckLeavesOpenWhatItDoesNotLookAt)
{
    const std::string program = planned(plainJob()).setups[0].text;
    for (const Job& job : {boredJob(), keyedJob()}) {
        const CheckResult check = checked(program, job);
        EXPECT_TRUE(check.findings.empty());
        EXPECT_EQ(check.verdict, Verdict::Undecided);
        EXPECT_TRUE(contains(check.notes, notes::drawnNotChecked));
        EXPECT_EQ(keyOf(answer(check).verdict_words), "? not all that is drawn is checked");
    }
    // Of threads, what no move cuts.
    const TurningPlan threaded = planned(threadedJob());
    EXPECT_TRUE(checked(threaded.setups[0].text, threadedJob()).not_checked.empty());
    Job without = threadedJob();
    without.shaft->segments[1].thread.clear();
    EXPECT_EQ(checked(planned(without).setups[0].text, threadedJob()).not_checked.size(), 1U);
}

}  // namespace
}  // namespace lathelier::cam
