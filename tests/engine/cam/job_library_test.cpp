// Inserts and holders of the library in a job.
#include "engine/cam/job_library.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/cam/cam_codes.h"
#include "engine/cam/job_bodies.h"
#include "engine/cam/job_file.h"
#include "engine/cam/plan_codes.h"
#include "engine/stock/tool_outline.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

TEST(ToolLibrary, EntriesAreWholeAndSayWhereTheyComeFrom)
{
    ASSERT_GE(cutting::toolLibrary().inserts.size(), 10U);
    for (const auto& entry : cutting::toolLibrary().inserts) {
        EXPECT_FALSE(entry.source.empty()) << entry.key;
        EXPECT_EQ(entry.value.standing, "assumed") << entry.key;
        ASSERT_TRUE(entry.value.edge_length_mm && entry.value.ranges.feed_high_mm_rev &&
                    entry.value.ranges.depth_high_mm);
        EXPECT_LE(*entry.value.ranges.feed_high_mm_rev, 0.8 * *entry.value.corner_radius_mm + 1e-9) << entry.key;
        EXPECT_LE(*entry.value.ranges.depth_high_mm, 2 * *entry.value.edge_length_mm / 3 + 0.05) << entry.key;
        EXPECT_LT(*entry.value.ranges.feed_low_mm_rev, *entry.value.ranges.feed_high_mm_rev) << entry.key;
    }
    for (const auto& entry : cutting::toolLibrary().holders) {
        EXPECT_FALSE(entry.source.empty()) << entry.key;
        EXPECT_GE(entry.value.holder.size(), 4U) << entry.key;
        for (const HolderCorner& corner : entry.value.holder)
            EXPECT_LE(entry.value.hand == Hand::TowardChuck ? corner.dz_mm : -corner.dz_mm, 0) << entry.key;
    }
}

TEST(ToolLibrary, NamedToolsAreFilledAndTypedValuesRule)
{
    Job job;
    job.tools.resize(2);
    job.tools[0].number = 1;
    job.tools[0].insert = "CNMG 120408";
    job.tools[0].holder_name = "PCLNL 2525 M12";
    job.tools[1].number = 2;
    job.tools[1].use = ToolUse::Finish;
    job.tools[1].insert = "DCMT 11T3 02";  // not listed: read from its code
    job.tools[1].corner_radius_mm = 0.25;
    job.tools[1].entering_angle_deg = 93;
    const Job filled = withLibrary(job);
    EXPECT_EQ(filled.tools[0].corner_radius_mm, 0.8);
    EXPECT_EQ(filled.tools[0].tip_angle_deg, 80.0);
    EXPECT_EQ(filled.tools[0].entering_angle_deg, 95.0);
    EXPECT_FALSE(filled.tools[0].holder.empty());
    EXPECT_EQ(filled.tools[1].corner_radius_mm, 0.25);
    EXPECT_EQ(filled.tools[1].tip_angle_deg, 55.0);
    EXPECT_EQ(withLibrary(filled), filled);
    job.tools[0].insert = "XXXX";
    try {
        withLibrary(job);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::toolNotInLibrary);
    }
}

TEST(ToolLibrary, AnEntryMoreIsThereForJobsAndForDeflection)
{
    // What a school adds to resources/library/inserts.json.
    const std::string added = R"({"inserts": [{"key": "rnmg_school", "entering_angle_deg": 60, "corner_radius_mm": 1.6,
        "tip_angle_deg": 70, "edge_length_mm": 14, "feed_high_mm_rev": 0.2, "standing": "given", "source": "ours"}]})";
    const cutting::ToolLibrary library = cutting::readToolLibrary(added, cutting::builtInHolders().front().text);
    Job job;
    job.tools.resize(1);
    job.tools[0].insert = "RNMG School";
    job.tools[0].holder_name = "PCLNL 2525M12";
    EXPECT_EQ(withLibrary(job, library).tools[0].corner_radius_mm, 1.6);
    EXPECT_EQ(withLibrary(job, library).tools[0].edge_length_mm, 14);
    EXPECT_THROW(withLibrary(job), Error);
    const std::vector<FieldChoice> choices = cutting::insertChoices({}, library);
    ASSERT_EQ(choices.size(), 2U);
    EXPECT_EQ(choices[1].key, "rnmg_school");
    EXPECT_EQ(choices[1].label, Text{"RNMG SCHOOL, 60°"});
}

TEST(ToolLibrary, WhatWasStatedStaysApartFromWhatIsFilledIn)
{
    Job job = jobWith({row(30, 20, 20), row(20, 30, 30)}, 34, 90, {});
    JobTool rough, finish;
    rough.number = 1;
    rough.insert = "CNMG 120408";
    rough.holder_name = "PCLNL 2525M12";
    finish.number = 2;
    finish.use = ToolUse::Finish;
    finish.insert = "CNMG 120408";
    finish.holder_name = "PCLNL 2525M12";
    job.tools = {rough, finish};
    Notes notes;
    EXPECT_EQ(readJob(jobText(job), notes), job);
    const TurningPlan plan = planned(job, "fanuc_a");
    EXPECT_EQ(plan.stated, job);
    EXPECT_EQ(plan.job.tools[1].corner_radius_mm, 0.8);
    // Another insert in what was stated is another tool.
    Job other = plan.stated;
    other.tools[1].insert = "DNMG 150604";
    other.tools[1].holder_name = "PDJNL 2525M15";
    const TurningPlan changed = planned(other, "fanuc_a");
    EXPECT_EQ(changed.job.tools[1].corner_radius_mm, 0.4);
    EXPECT_EQ(changed.job.tools[1].tip_angle_deg, 55.0);
    EXPECT_EQ(changed.job.tools[1].entering_angle_deg, 93.0);
}

TEST(ToolLibrary, AnInsertThatDoesNotFitItsHolderIsNoted)
{
    EXPECT_TRUE(cutting::fitsHolder("CNMG 120408", "PCLNL 2525M12"));
    EXPECT_TRUE(cutting::fitsHolder("CCMT 09T304", "SCLCL2020K09"));
    EXPECT_FALSE(cutting::fitsHolder("CNMG 120408", "PDJNL 2525M15"));  // shape
    EXPECT_FALSE(cutting::fitsHolder("CNMG 160612", "PCLNL 2525M12"));  // size
    EXPECT_FALSE(cutting::fitsHolder("CCMT 120408", "PCLNL 2525M12"));  // clearance
    EXPECT_TRUE(cutting::fitsHolder("CNMG 120408", "my holder"));
    EXPECT_TRUE(cutting::fitsHolder("", ""));
    Job job = jobWith({row(30, 20, 20), row(20, 30, 30)}, 34, 90, {roughC80(), finishC80()});
    EXPECT_FALSE(contains(planned(job).notes, notes::insertNotOfHolder));
    job.tools[1].insert = "CNMG 120404";
    job.tools[1].holder_name = "PDJNL 2525M15";
    EXPECT_TRUE(contains(planned(job).notes, notes::insertNotOfHolder));
}

TEST(ToolLibrary, PlansWithHoldersOfTheLibrary)
{
    Job job = jobWith({row(1, 18, 20), row(30, 20, 20), row(25, 30, 30), row(20, 38, 38)}, 42, 100, {});
    JobTool rough, finish;
    rough.number = 1;
    rough.insert = "CNMG 120408";
    rough.holder_name = "PCLNL 2525M12";
    finish.number = 2;
    finish.use = ToolUse::Finish;
    finish.insert = "DNMG 150604";
    finish.holder_name = "PDJNL 2525M15";
    job.tools = {rough, finish};
    const TurningPlan plan = planned(job, "fanuc_a");
    expectSound(plan, "library");
    // Assumed values are noted, also in the head of the program.
    EXPECT_EQ(std::count_if(plan.notes.begin(), plan.notes.end(),
                            [](const Note& note) { return note.code == notes::toolFromLibrary; }),
              4);
    EXPECT_NE(plan.setups[0].text.find("ASSUMED: T1 OUTLINE OF PCLNL 2525M12"), std::string::npos);
    EXPECT_EQ(plan.job.tools[1].corner_radius_mm, 0.4);
    job.cutting.finish.feed_mm_rev = 0.5;
    EXPECT_TRUE(contains(planned(job, "fanuc_a").notes, notes::outsideRange));
    // An allowance that is less than the insert's least depth.
    job.cutting.finish.feed_mm_rev = 0.1;
    ASSERT_FALSE(contains(planned(job, "fanuc_a").notes, notes::outsideRange));
    job.cutting.rough.allowance_mm = 0.05;
    EXPECT_TRUE(contains(planned(job, "fanuc_a").notes, notes::outsideRange));
}

TEST(ToolLibrary, DeepRestIsTakenInPasses)
{
    // A fall of 6 mm: the 80° insert leaves it, the 55° one finishes it in passes of 1.5 mm at most.
    const Job job = jobWith({row(20, 34, 34), row(8, 34, 22), row(25, 22, 22), row(10, 36, 36)}, 40, 100,
                            {roughC80(), finishD55()});
    const TurningPlan plan = planned(job, "linuxcnc");
    expectSound(plan, "deep");
    EXPECT_FALSE(contains(plan.notes, notes::finishCutsDeep));
    std::size_t passes = 0;
    for (const PlannedOperation& operation : plan.setups[0].operations)
        passes += operation.kind == OperationKind::SemiFinish && operation.tool == 3 ? 1 : 0;
    EXPECT_EQ(passes, 1U);
    // Finishing removes at most one step.
    const PlannedOperation& last = plan.setups[0].operations.back();
    EXPECT_EQ(last.kind, OperationKind::Finish);
    EXPECT_LT(last.volume_cm3, 0.4 * 3.1416 * 6 * 1.4 * 7);
}

}  // namespace
}  // namespace lathelier::cam
