// The work before the second clamping: parted off, faced, or cut off by hand at a stop.
#include <gtest/gtest.h>

#include "engine/cam/cam_codes.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/post/cut_off_stop.h"
#include "tests/engine/cam/cam_data.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

/// 92 mm long, of a bar of 40 mm.
Job longJob(std::optional<double> bar_mm)
{
    Job job = jobWith({row(30, 20, 20), row(32, 36, 36), row(30, 24, 24)}, 40, 100, {roughC80(), finishC80()});
    job.stock.length_mm = bar_mm;
    return job;
}

CheckResult checkedSecond(const TurningPlan& plan, const Job& job, const std::string& text)
{
    CheckParameters parameters;
    parameters.setup = 2;
    parameters.chuck_face_z_mm = plan.setups[1].clamping.job.setup.chuck_face_z_mm;
    CheckInputs inputs;
    inputs.before = plan.setups[0].text;
    return checked(text, job, parameters, inputs);
}

bool hasStandingEnd(const CheckResult& check)
{
    return std::any_of(check.findings.begin(), check.findings.end(),
                       [](const CheckFinding& found) { return found.kind == CheckKind::StandingEnd; });
}

TEST(SecondWork, LongEndIsCutOffAtAStop)
{
    for (const std::string& post : postNames()) {
        const TurningPlan plan = planned(longJob(150), post.c_str(), SetupChoice::Two);
        ASSERT_EQ(plan.setups.size(), 2U);
        expectSound(plan, post);
        EXPECT_EQ(plan.setups[1].clamping.cut_off_to_mm, 93);
        EXPECT_TRUE(contains(plan.notes, notes::cutOffFirst));
        const std::string& text = plan.setups[1].text;
        EXPECT_NE(text.find("CUT OFF TO 93.0 FIRST"), std::string::npos) << text;
        EXPECT_EQ(cutOffOf(text), 93) << text;
        EXPECT_FALSE(cutOffOf(plan.setups[0].text));
        EXPECT_LT(text.find("M0"), text.find("G1 ")) << "the stop comes before the first cut";
    }
}

TEST(SecondWork, CheckKnowsWhatStandsBeyondThePart)
{
    const Job job = longJob(150);
    const TurningPlan plan = planned(job, "linuxcnc", SetupChoice::Two);
    const CheckResult as_written = checkedSecond(plan, job, plan.setups[1].text);
    EXPECT_TRUE(as_written.findings.empty());
    EXPECT_TRUE(contains(as_written.notes, notes::workCutOff));
    // Without the stop the insert would plunge beside an end of 57 mm.
    const std::string unstopped = replaced(plan.setups[1].text, "\nM0\n", "\n");
    const CheckResult check = checkedSecond(plan, job, unstopped);
    EXPECT_TRUE(hasStandingEnd(check));
    EXPECT_EQ(check.verdict, Verdict::Fail);
    for (const CheckFinding& found : check.findings)
        if (found.kind == CheckKind::StandingEnd) {
            EXPECT_NEAR(found.depth_mm, 57, 0.1);
        }
}

TEST(SecondWork, ShortEndIsFaced)
{
    const TurningPlan plan = planned(longJob(95.5), "linuxcnc", SetupChoice::Two);
    ASSERT_EQ(plan.setups.size(), 2U);
    expectSound(plan, "2.5 mm beyond the part");
    EXPECT_FALSE(plan.setups[1].clamping.cut_off_to_mm);
    EXPECT_EQ(plan.setups[1].clamping.job.stock.face_allowance_mm, 2.5);
    EXPECT_EQ(plan.setups[1].text.find("CUT OFF"), std::string::npos);
    EXPECT_FALSE(hasStandingEnd(checkedSecond(plan, longJob(95.5), plan.setups[1].text)));
}

TEST(SecondWork, UnknownLengthIsCutOffToo)
{
    const Job job = longJob({});
    const TurningPlan plan = planned(job, "linuxcnc", SetupChoice::Two);
    EXPECT_EQ(plan.setups[1].clamping.cut_off_to_mm, 93);
    const CheckResult check = checkedSecond(plan, job, replaced(plan.setups[1].text, "\nM0\n", "\n"));
    EXPECT_TRUE(contains(check.notes, notes::cutOffAssumed));
    EXPECT_TRUE(check.findings.empty());
}

TEST(SecondWork, PartedOffNeedsNoStop)
{
    Job job = longJob(150);
    job.tools.push_back(blade(8, ToolUse::PartOff, 3, 0.2, 30));
    job.part_off = true;
    const TurningPlan plan = planned(job, "linuxcnc", SetupChoice::Two);
    ASSERT_EQ(plan.setups.size(), 2U);
    EXPECT_FALSE(plan.setups[1].clamping.cut_off_to_mm);
    EXPECT_FALSE(cutOffOf(plan.setups[1].text));
}

TEST(SecondWork, StopIsReadWithItsComment)
{
    EXPECT_EQ(cutOffComment(93), "cut off to 93.0 first");
    EXPECT_EQ(cutOffComment(92.75), "cut off to 92.75 first");
    EXPECT_EQ(cutOffOf("%\n(CUT OFF TO 93.0 FIRST)\nN20 M0\n"), 93);
    EXPECT_EQ(cutOffOf("; Cut off to 92.75 first\r\nN20 M00\r\n"), 92.75);
    EXPECT_FALSE(cutOffOf("(CUT OFF TO 93.0 FIRST)\nG0 X10\nM0\n"));
    EXPECT_FALSE(cutOffOf("(CUT OFF TO 93.0)\nM0\n"));
    EXPECT_FALSE(cutOffOf("M0\n"));
}

}  // namespace
}  // namespace lathelier::cam
