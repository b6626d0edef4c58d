// Programs against the interpreter of LinuxCNC (rs274, package linuxcnc-uspace), which has to be installed. Every move
// is compared: kind, end, centre and sense of an arc, feed or lead, speed, dwell. LATHELIER_SOAK=1000 runs as many
// random programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/engine/gcode/random_lathe_program.h"
#include "tests/engine/gcode/rs274_moves.h"
#include "tests/engine/gcode/run_program.h"
#include "tests/scratch_folder.h"

namespace lathelier::gcode {
namespace {

/// What a difference may come to: four digits are printed, of the move and of two shifts of the zero.
double limitOf(const std::string& program)
{
    constexpr double printed = 1.6e-4;
    return program.find("G20") == std::string::npos ? printed : printed * 25.4;
}

bool isNear(double a, double b, double limit)
{
    return (!isKnown(a) && !isKnown(b)) || std::abs(a - b) <= limit;
}

/// Why two moves differ; empty: they do not.
std::string difference(const Move& ours, const Move& theirs, const Move& before, double limit_mm)
{
    if (ours.kind != theirs.kind) return "kind";
    if (ours.kind == MoveKind::Dwell) return isNear(ours.dwell_s, theirs.dwell_s, 1e-4) ? "" : "dwell";
    if (!isNear(ours.x_mm, theirs.x_mm, limit_mm)) return "x";
    if (!isNear(ours.z_mm, theirs.z_mm, limit_mm)) return "z";
    // The lead of a tapered entry or exit of a thread is printed along the move, ours counts along Z.
    const bool isAcross = ours.kind == MoveKind::Thread && std::abs(ours.x_mm - before.x_mm) > limit_mm;
    if (!isAcross && !isNear(ours.feed_mm_rev, theirs.feed_mm_rev, limit_mm)) return "feed per revolution";
    if (!isNear(ours.feed_mm_min, theirs.feed_mm_min, limit_mm)) return "feed per minute";
    if (!isNear(ours.speed_rpm, theirs.speed_rpm, 1e-3)) return "speed";
    if (!isNear(ours.cutting_speed_m_min, theirs.cutting_speed_m_min, 1e-3)) return "cutting speed";
    if (!isNear(ours.speed_limit_rpm, theirs.speed_limit_rpm, 1e-3)) return "limit of the speed";
    if (ours.kind != MoveKind::Arc) return "";
    if (!isNear(ours.centre_x_mm, theirs.centre_x_mm, limit_mm)) return "centre x";
    if (!isNear(ours.centre_z_mm, theirs.centre_z_mm, limit_mm)) return "centre z";
    return ours.clockwise == theirs.clockwise ? "" : "sense";
}

std::string shownMove(const Move& move)
{
    return fmt::format("{} x{:.4f} z{:.4f} centre x{:.4f} z{:.4f} cw{} f{:.4f} {:.4f} s{:.3f} v{:.3f} limit{} dwell{}",
                       key(move.kind), move.x_mm, move.z_mm, move.centre_x_mm, move.centre_z_mm, move.clockwise,
                       move.feed_mm_rev, move.feed_mm_min, move.speed_rpm, move.cutting_speed_m_min,
                       move.speed_limit_rpm, move.dwell_s);
}

/// Where the moves of a program differ; empty: nowhere.
std::string differenceOf(const std::vector<Move>& ours, const std::vector<Move>& theirs, double limit_mm)
{
    Move before;
    before.x_mm = before.z_mm = 0;
    for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
        const std::string why = difference(ours[i], theirs[i], before, limit_mm);
        if (!why.empty())
            return fmt::format("{} of move {}, line {}\n  ours   {}\n  theirs {}\n", why, i, ours[i].line,
                               shownMove(ours[i]), shownMove(theirs[i]));
        if (ours[i].kind != MoveKind::Dwell) before = ours[i];
    }
    return ours.size() == theirs.size() ? std::string()
                                        : fmt::format("{} moves, theirs {}\n", ours.size(), theirs.size());
}

void expectSameMoves(const std::string& program, const ScratchFolder& folder)
{
    const Toolpath path = pathOf(program, "linuxcnc");
    ASSERT_FALSE(path.has_errors) << program;
    const auto theirs = madeByLinuxCnc(program, folder.path(), true);
    ASSERT_TRUE(theirs) << program;
    EXPECT_EQ(differenceOf(path.moves, *theirs, limitOf(program)), "") << program;
}

TEST(Rs274, IsInstalled)
{
    ASSERT_TRUE(std::filesystem::exists(LATHELIER_RS274)) << "rs274 of the package linuxcnc-uspace judges the moves";
}

TEST(Rs274, KeptProgramsMoveAlike)
{
    const ScratchFolder folder;
    for (const char* name : {"caseA_linuxcnc.ngc", "contour_linuxcnc.ngc", "flow.ngc"})
        expectSameMoves(keptProgram(name), folder);
}

TEST(Rs274, ThreadingCyclesMoveAlike)
{
    const ScratchFolder folder;
    for (const char* words : {"I-2 E1.5 L0", "I-2 E1.5 L1", "I-2 E1.5 L2", "I-2 E1.5 L3", "I3 E1 L3"})
        expectSameMoves(fmt::format("G18 G21 G7 G90 G97 S500 M3\nG0 X24 Z3\n"
                                    "G76 P1.5 Z-20 {} J0.2 R1.5 K0.92 Q29.5 H1\nG0 X50 Z50\nM2\n",
                                    words),
                        folder);
}

TEST(Rs274, RandomProgramsMoveAlike)
{
    const ScratchFolder folder;
    const char* soak = std::getenv("LATHELIER_SOAK");  // NOLINT(concurrency-mt-unsafe)
    const int count = soak ? std::atoi(soak) : 60;     // NOLINT(cert-err34-c)
    int moved = 0, refused = 0, gaps = 0, cycles = 0, differ = 0, accepted = 0;
    for (int i = 1; i <= count; ++i) {
        RandomLatheProgram random(static_cast<std::uint32_t>(i));
        const std::string program = random.text();
        const auto theirs = madeByLinuxCnc(program, folder.path(), true);
        const Toolpath path = pathOf(program, "linuxcnc");
        cycles += random.hasCycles();
        const bool hasGap = path.understanding.first() != nullptr;
        if (random.hasCycles() && (hasGap || path.has_errors || !theirs)) {
            // What is not modelled, or refused by both. What it refuses must not be taken for understood.
            ++(hasGap ? gaps : refused);
            accepted += !theirs && !hasGap && !path.has_errors;
            EXPECT_TRUE(!path.has_errors || !theirs) << "seed " << i << '\n' << program;
            continue;
        }
        ASSERT_TRUE(theirs) << "seed " << i << '\n' << program;
        EXPECT_FALSE(path.has_errors) << "seed " << i << '\n' << program;
        EXPECT_FALSE(hasGap) << "seed " << i << '\n' << program;
        const std::string why = differenceOf(path.moves, *theirs, limitOf(program));
        EXPECT_EQ(why, "") << "seed " << i << '\n' << program;
        differ += !why.empty();
        ++moved;
    }
    EXPECT_EQ(accepted, 0);
    fmt::print("{} programs alike, {} differ; of {} with cycles over contours {} refused by both, {} not modelled\n",
               moved - differ, differ, cycles, refused, gaps);
}

}  // namespace
}  // namespace lathelier::gcode
