// Planned programs against the interpreter of LinuxCNC (rs274), which has to be installed.
//
// Stand-alone rs274 has no tool table: moves are those of the tip, as written by a plan. X is printed as radius with
// four decimals. Absence of errors is not sufficient, so its moves are compared with ours.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/engine/cam/plan_checks.h"
#include "tests/engine/gcode/rs274_moves.h"
#include "tests/scratch_folder.h"

namespace lathelier::cam {
namespace {

/// Largest difference of the moves that rs274 makes of a program from ours, in mm.
double differenceOf(const SetupPlan& setup, const ScratchFolder& folder, const std::string& what)
{
    std::vector<gcode::Move> ours;
    for (const gcode::Move& move : setup.check.path.moves)
        if (move.kind != gcode::MoveKind::Dwell) ours.push_back(move);
    const std::vector<gcode::Move> theirs = gcode::movesOfLinuxCnc(setup.text, folder.path());
    EXPECT_EQ(ours.size(), theirs.size()) << what;
    double largest = ours.size() == theirs.size() ? 0 : 1e9;
    for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
        const bool is_arc = theirs[i].kind == gcode::MoveKind::Arc;
        EXPECT_EQ(ours[i].kind == gcode::MoveKind::Arc, is_arc) << what << " line " << ours[i].line;
        EXPECT_EQ(ours[i].kind == gcode::MoveKind::Rapid, theirs[i].kind == gcode::MoveKind::Rapid) << what;
        // Before the first position of a tool is complete, rs274 counts from the machine's zero.
        if (gcode::isKnown(ours[i].x_mm)) largest = std::max(largest, std::abs(ours[i].x_mm - theirs[i].x_mm));
        if (gcode::isKnown(ours[i].z_mm)) largest = std::max(largest, std::abs(ours[i].z_mm - theirs[i].z_mm));
        if (!is_arc) continue;
        EXPECT_EQ(ours[i].clockwise, theirs[i].clockwise) << what << " line " << ours[i].line;
        largest = std::max({largest, std::abs(ours[i].centre_x_mm - theirs[i].centre_x_mm),
                            std::abs(ours[i].centre_z_mm - theirs[i].centre_z_mm)});
    }
    return largest;
}

TEST(PlanRs274, PracticeJobsMoveAlike)
{
    const ScratchFolder folder;
    for (const Practice& practice : practiceJobs())
        for (const SetupPlan& setup : planned(practice.job, "linuxcnc").setups)
            EXPECT_LT(differenceOf(setup, folder, practice.name), 0.001) << practice.name;
}

TEST(PlanRs274, RandomShaftsMoveAlike)
{
    const ScratchFolder folder;
    const char* soak = std::getenv("LATHELIER_SOAK");
    const int count = soak ? std::atoi(soak) : 20;
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        std::mt19937 random(static_cast<unsigned>(7000 + i));
        const Job job = randomJob(random, i % 2 == 1);
        for (const SetupPlan& setup : planned(job, "linuxcnc").setups)
            worst = std::max(worst, differenceOf(setup, folder, "shaft " + std::to_string(i)));
    }
    EXPECT_LT(worst, 0.001);
    RecordProperty("largest_difference_um", std::to_string(1000 * worst));
}

TEST(PlanRs274, TailstockAndThreadMoveAlike)
{
    const ScratchFolder folder;
    const TurningPlan plan = planned(threadedJob(), "linuxcnc");
    EXPECT_LT(differenceOf(plan.setups[0], folder, "thread"), 0.001);
    const TurningPlan held = planned(tailstockJob(), "linuxcnc");
    EXPECT_LT(differenceOf(held.setups[0], folder, "tailstock"), 0.001);
}

}  // namespace
}  // namespace lathelier::cam
