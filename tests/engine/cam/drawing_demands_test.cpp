// Requirements of a row besides its shape: roughness, limits, threads, edges.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/cam/clampings.h"
#include "engine/cam/cutting_data.h"
#include "engine/cam/edges.h"
#include "engine/cam/job_file.h"
#include "engine/cam/plan_codes.h"
#include "engine/cam/speed_words.h"
#include "engine/cam/threads.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

const Note* noteOf(const Notes& notes, const NoteCode& code)
{
    const auto found = std::find_if(notes.begin(), notes.end(), [&](const Note& note) { return note.code == code; });
    return found == notes.end() ? nullptr : &*found;
}

double numberOf(const Note& note, const char* key)
{
    const Value* value = find(note.values, key);
    return value && std::holds_alternative<double>(*value) ? std::get<double>(*value) : -1;
}

TEST(DrawingDemands, AreReadWithTheShaft)
{
    Notes notes;
    const Job job = readJob(R"({"shaft": {"segments": [
        {"length_mm": 20, "start_diameter_mm": 16, "end_diameter_mm": 16, "thread": "M16x1.5"},
        {"length_mm": 30, "start_diameter_mm": 24, "end_diameter_mm": 24, "Rz_um": 4, "tolerance_um": 21}]},
        "stock": {"diameter_mm": 30}, "setup": {"chuck_face_z_mm": 70},
        "tools": [{"number": 1, "use": "rough", "nose_radius_mm": 0.8, "entering_angle_deg": 95, "tip_angle_deg": 80},
                  {"number": 2, "use": "finish", "nose_radius_mm": 0.4, "entering_angle_deg": 95, "tip_angle_deg": 80}],
        "cutting": {"rough": {"depth_mm": 2, "feed_mm_rev": 0.25, "cutting_speed_m_min": 190},
                    "finish": {"feed_mm_rev": 0.15, "cutting_speed_m_min": 190}}})",
                            notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(job.shaft->segments[0].thread, "M16x1.5");
    EXPECT_EQ(job.shaft->segments[1].Rz_um, 4.0);
    EXPECT_EQ(job.shaft->segments[1].tolerance_um, 21.0);
    Notes again;
    EXPECT_EQ(readJob(jobText(job), again), job);
}

TEST(DrawingDemands, RoughnessMakesTheFeedSmaller)
{
    // f .1, r .4, κ' 5°: 2.97 µm.
    Job job = jobWith({row(20, 20, 20), row(20, 26, 26), row(20, 32, 32)}, 36, 90, {roughC80(), finishC80()});
    job.shaft->segments[1].Rz_um = 1.5;
    job.shaft->segments[2].Rz_um = 6;
    const TurningPlan plan = planned(job, "linuxcnc");
    expectSound(plan, "roughness");
    const Note* note = noteOf(plan.notes, notes::feedForRoughness);
    ASSERT_NE(note, nullptr);
    const double feed = numberOf(*note, "feed_mm_rev");
    EXPECT_LE(idealRz_um(feed, 0.4, 5), 1.5);
    EXPECT_GT(idealRz_um(feed + 0.002, 0.4, 5), 1.5);
    for (const Operation& operation : plan.setups[0].moves) {
        if (operation.kind != OperationKind::Finish) continue;
        for (std::size_t i = 1; i < operation.moves.size(); ++i) {
            const CutMove& move = operation.moves[i];
            const double from = operation.moves[i - 1].to.x();
            if (move.kind != CutKind::Line || move.to.x() - from < 10) continue;
            EXPECT_NEAR(move.feed_mm_rev, from > 15 && move.to.x() < 45 ? feed : 0.1, 1e-9) << from;
        }
    }
    EXPECT_EQ(noteOf(plan.notes, notes::roughnessNotReached), nullptr);
    job.shaft->segments[1].Rz_um = 0.01;
    EXPECT_NE(noteOf(planned(job, "linuxcnc").notes, notes::roughnessNotReached), nullptr);
}

TEST(DrawingDemands, GripAvoidsACylinderWithLimits)
{
    Job job = paperJob({roughC80(), finishC80()});
    double missing = 0;
    const double split = *splitOf(*job.shaft);
    std::optional<Grip> grip = gripBefore(*job.shaft, job, split, missing);
    ASSERT_TRUE(grip);
    EXPECT_FALSE(grip->has_tolerance);
    // The only one there is.
    job.shaft->segments[0].tolerance_um = 13;
    grip = gripBefore(*job.shaft, job, split, missing);
    ASSERT_TRUE(grip);
    EXPECT_TRUE(grip->has_tolerance);
    // The shorter one without limits is preferred.
    Shaft part;
    part.segments = {row(60, 24, 24), row(30, 30, 30), row(40, 37, 37), row(30, 20, 20)};
    part.segments[0].tolerance_um = 13;
    grip = gripBefore(part, job, *splitOf(part), missing);
    ASSERT_TRUE(grip);
    EXPECT_FALSE(grip->has_tolerance);
    EXPECT_NEAR(grip->from_mm, 60, 1e-9);
}

Operation stepped(double z, double low, double high)
{
    Operation finish;
    finish.kind = OperationKind::Finish;
    MoveList moves(Eigen::Vector2d(0, 0));
    moves.rapid({-1, low});
    moves.line({z, low}, 0.1);
    moves.line({z, high}, 0.1);
    moves.line({2 * z, high}, 0.1);
    moves.rapid({2 * z, high + 5});
    finish.moves = moves.taken();
    return finish;
}

std::vector<SectionSpeed> sectionsAt(double z, double first, double second)
{
    std::vector<SectionSpeed> sections(2);
    sections[0].z_end_mm = z;
    sections[0].speed_rpm = first;
    sections[1].z_start_mm = z;
    sections[1].z_end_mm = 2 * z;
    sections[1].speed_rpm = second;
    return sections;
}

/// Length of feed moves from the speed change to the cylinder of the second section.
double wayBefore(const Operation& finish, double speed, double high)
{
    double way = 0;
    bool is_changed = false;
    for (std::size_t i = 1; i < finish.moves.size(); ++i) {
        const CutMove &move = finish.moves[i], &before = finish.moves[i - 1];
        const bool is_second = move.to.y() == high && before.to.y() == high && move.to.x() > before.to.x();
        is_changed = is_changed || move.speed_rpm == speed;
        if (is_second) return is_changed ? way : -1;
        if (is_changed) way += (move.to - before.to).norm();
    }
    return -1;
}

TEST(SpeedRamps, StandBeforeTheSection)
{
    Shaft part;
    part.segments = {row(50, 30, 30), row(50, 32, 32)};
    const double ramp = 0.1 * (2154 + 1750) / 120 * (2154 - 1750) / 1000;
    // A face of 3 mm is long enough.
    Operation high = stepped(50, 15, 18);
    setFinishSpeeds(high, sectionsAt(50, 2154, 1750), part);
    EXPECT_EQ(high.moves.size(), 5U);
    EXPECT_EQ(high.moves[2].speed_rpm, 1750);
    // One of 1 mm is not: the remaining length is on the previous cylinder, which has no limits.
    Operation low = stepped(50, 15, 16);
    setFinishSpeeds(low, sectionsAt(50, 2154, 1750), part);
    EXPECT_NEAR(wayBefore(low, 1750, 16), ramp, 1e-9);
    // With limits on it the speed does not change there: the tool lifts off and comes back.
    part.segments[0].tolerance_um = 20;
    Operation held = stepped(50, 15, 16);
    setFinishSpeeds(held, sectionsAt(50, 2154, 1750), part);
    EXPECT_GE(wayBefore(held, 1750, 16), ramp - 1e-9);
    for (std::size_t i = 1; i < held.moves.size(); ++i) {
        const CutMove &move = held.moves[i], &before = held.moves[i - 1];
        if (move.speed_rpm) {
            EXPECT_FALSE(move.to.y() == 15 && before.to.y() == 15);
        }
        if (move.to.x() < 50 - 1e-9) {
            EXPECT_FALSE(move.speed_rpm);
        }
    }
}

TEST(SpeedRamps, FallingStepLiftsFromItsEdge)
{
    Shaft part;
    part.segments = {row(50, 32, 32), row(50, 30, 30)};
    part.segments[0].Rz_um = 4;
    Operation finish = stepped(50, 16, 15);
    setFinishSpeeds(finish, sectionsAt(50, 1750, 2154), part);
    EXPECT_GE(wayBefore(finish, 2154, 15), 0.1 * (2154 + 1750) / 120 * (2154 - 1750) / 1000 - 1e-9);
    ASSERT_EQ(finish.moves.size(), 7U);
    EXPECT_EQ(finish.moves[2].speed_rpm, 2154);
    EXPECT_GT(finish.moves[2].to.y(), 16);
    EXPECT_EQ(finish.moves[3].to, finish.moves[1].to);
}

TEST(Edges, AreBrokenWhereAFaceMeetsARow)
{
    Shaft part;
    part.segments = {row(20, 20, 20), row(20, 30, 30), row(20, 24, 24)};
    const BrokenEdges broken = brokenEdges(part, 0.5);
    EXPECT_EQ(broken.count, 3);
    EXPECT_EQ(broken.left, 0);
    EXPECT_NEAR(broken.part.length_mm(), 60, 1e-9);
    ASSERT_EQ(broken.part.segments.size(), 6U);
    EXPECT_EQ(broken.part.segments[0].start_diameter_mm, 19);
    EXPECT_EQ(broken.part.segments[0].end_diameter_mm, 20);
    EXPECT_EQ(broken.part.segments[4].end_diameter_mm, 29);
    EXPECT_EQ(brokenEdges(broken.part, 0.5).part, broken.part);
    EXPECT_EQ(brokenEdges(part, 0).part, part);
    part.segments[1].length_mm = 1;
    EXPECT_EQ(brokenEdges(part, 0.5).left, 2);
}

TEST(Edges, TheOtherEndIsBrokenByTheSecondClamping)
{
    Job job = paperJob({roughC80(), finishC80()});
    job.shaft->segments = {row(60, 30, 30), row(30, 37, 37), row(60, 33.8, 33.8)};
    job.edge_break_mm = 0.3;
    EXPECT_EQ(brokenEdges(*job.shaft, 0.3, true).count, brokenEdges(*job.shaft, 0.3).count + 1);
    const TurningPlan plan = planned(job, "linuxcnc", SetupChoice::Two);
    ASSERT_EQ(plan.setups.size(), 2U);
    expectSound(plan, "both ends");
    EXPECT_NEAR(plan.part.segments.back().end_diameter_mm, 33.2, 1e-9);
    for (const RestInterval& rest : plan.rest) EXPECT_LT(rest.z_end_mm, 149);
    // The check of the second program includes the chamfer; against the drawing with sharp edges it is a gouge.
    CheckParameters second = plan.setups[1].check.parameters;
    CheckInputs inputs;
    inputs.before = plan.setups[0].text;
    EXPECT_LE(checkTurning(plan.setups[1].text, *job.shaft, job, second, inputs).gouge_um, 1.5);
    job.edge_break_mm = 0;
    EXPECT_NEAR(checkTurning(plan.setups[1].text, *job.shaft, job, second, inputs).gouge_um, 300 / std::sqrt(2.0), 3);
}

TEST(Edges, TheEndIsBrokenBeforeItIsCutOff)
{
    Job job = jobWith({row(40, 30, 30), row(20, 37, 37)}, 40, 90,
                      {roughC80(), finishC80(), blade(8, ToolUse::PartOff, 3, 0.2, 25)});
    job.part_off = true;
    job.edge_break_mm = 0.5;
    const TurningPlan plan = planned(job, "fanuc_a");
    expectSound(plan, "cut off");
    EXPECT_NEAR(plan.part.segments.back().end_diameter_mm, 36, 1e-9);
    for (const RestInterval& rest : plan.rest)
        if (rest.z_end_mm > 59) {
            EXPECT_LT(rest.left_mm, 0.05);
        }
    EXPECT_EQ(plan.setups[0].operations.back().kind, OperationKind::PartOff);
    job.edge_break_mm = 0;
    EXPECT_NEAR(checkTurning(plan.setups[0].text, *job.shaft, job).gouge_um, 500 / std::sqrt(2.0), 3);
}

TEST(Edges, ProgramBreaksThem)
{
    Job job = jobWith({row(20, 20, 20), row(20, 30, 30)}, 36, 90, {roughC80(), finishV35()});
    job.edge_break_mm = 0.3;
    const TurningPlan plan = planned(job, "fanuc_a");
    expectSound(plan, "edges");
    ASSERT_NE(noteOf(plan.notes, notes::edgesBroken), nullptr);
    job.edge_break_mm = 0;
    const CheckResult sharp = checkTurning(plan.setups[0].text, *job.shaft, job);
    EXPECT_NEAR(sharp.gouge_um, 300 / std::sqrt(2.0), 2);
}

TEST(Threads, AreFoundInRowsAndMarks)
{
    Shaft part;
    part.segments = {row(20, 16, 16), row(20, 24, 24), row(20, 30, 30)};
    part.segments[0].thread = "M16×1,5-6g";
    part.segments[1].thread = "M24 LH";
    ShaftMark mark;
    mark.kind = MarkKind::Thread;
    mark.designation = "special";
    mark.z_start_mm = 45;
    mark.z_end_mm = 55;
    mark.pitch_mm = 2;
    part.marks = {mark};
    const std::vector<DrawnThread> found = threadsOf(part);
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].pitch_mm, 1.5);
    EXPECT_TRUE(found[0].is_plain);
    EXPECT_EQ(found[1].pitch_mm, 3.0);
    EXPECT_FALSE(found[1].is_plain);
    EXPECT_EQ(found[2].pitch_mm, 2.0);
    EXPECT_EQ(mirrored(found, 60)[2].z_start_mm, 5);
}

TEST(Threads, AreCutByAllPostsButGrbl)
{
    for (const std::string& post : postNames()) {
        if (post == "grbl") {
            EXPECT_THROW(planned(threadedJob(), "grbl"), Error);
            continue;
        }
        const TurningPlan plan = planned(threadedJob(), post.c_str());
        expectSound(plan, post);
        std::size_t passes = 0;
        double deepest = 1e9;
        for (const gcode::Move& move : plan.setups[0].check.path.moves) {
            if (move.kind != gcode::MoveKind::Thread) continue;
            ++passes;
            EXPECT_NEAR(move.feed_mm_rev, 2, 1e-9) << post;
            EXPECT_GT(move.speed_rpm, 0) << post;
            deepest = std::min(deepest, move.x_mm);
        }
        EXPECT_GT(passes, 4U) << post;
        EXPECT_NEAR(deepest, 12 - 0.6134 * 2, 0.001) << post;
        EXPECT_NE(noteOf(plan.notes, notes::threadCut), nullptr) << post;
    }
}

TEST(Threads, DiametersHaveToFitTheRow)
{
    Job job = threadedJob();
    job.shaft->segments[1].thread = "M16x2";  // on a row of 24 mm
    EXPECT_NE(noteOf(planned(job, "haas").notes, notes::threadNotPlanned), nullptr);
    job.shaft->segments[1].thread.clear();
    ShaftMark mark;
    mark.kind = MarkKind::Thread;
    mark.designation = "special";
    mark.z_start_mm = 2;
    mark.z_end_mm = 27;
    mark.pitch_mm = 2;
    mark.major_mm = 24;
    mark.minor_mm = 21.4;
    job.shaft->marks = {mark};
    const TurningPlan plan = planned(job, "haas");
    expectSound(plan, "root as drawn");
    const Note* cut = noteOf(plan.notes, notes::threadCut);
    ASSERT_NE(cut, nullptr);
    EXPECT_NEAR(std::get<double>(*find(cut->values, "depth_mm")), 1.3, 1e-9);
    job.shaft->marks[0].minor_mm = 23;  // no thread of this pitch
    EXPECT_NE(noteOf(planned(job, "haas").notes, notes::threadNotPlanned), nullptr);
    job.shaft->marks[0].minor_mm.reset();
    job.shaft->marks[0].major_mm = 22;
    EXPECT_NE(noteOf(planned(job, "haas").notes, notes::threadNotPlanned), nullptr);
}

TEST(Threads, WithoutAToolAreNoted)
{
    Job job = threadedJob();
    job.tools.pop_back();
    const TurningPlan plan = planned(job, "grbl");
    expectSound(plan, "no tool");
    const Note* note = noteOf(plan.notes, notes::threadNotPlanned);
    ASSERT_NE(note, nullptr);
    job = threadedJob();
    job.shaft->segments[1].thread = "Tr24x5";
    EXPECT_NE(noteOf(planned(job, "haas").notes, notes::threadNotPlanned), nullptr);
}

}  // namespace
}  // namespace lathelier::cam
