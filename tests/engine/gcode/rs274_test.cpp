// Programs against the interpreter of LinuxCNC (rs274, package linuxcnc-uspace), which has to be installed. Every move
// is compared: kind, end, centre and sense of an arc, feed or lead, speed, dwell. LATHELIER_SOAK=1000 runs as many
// random programs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

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
    for (const char* name : {"caseA_linuxcnc.ngc", "contour_linuxcnc.ngc", "flow.ngc",
                             "cases/c01_linuxcnc_g71_missing.ngc", "cases/c51_check_green_g70.ngc"})
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

TEST(Rs274, ProgramsThatAreCalledByM98MoveAlike)
{
    const std::string head = "G18 G21 G90 G7\nG97 S500 M3\nG0 X36 Z2\nG1 X32 Z2 F0.2\n";
    const std::string cut = "O100\nG1 Z-5\nM99\n";
    const ScratchFolder folder;
    expectSameMoves("O1\n" + head + "M98 P100\nM5\nM30\n" + cut, folder);
    expectSameMoves(head + "M98 P100 L3\nM2\nO100\nG91\nG1 Z-5\nG90\nM99\n", folder);
    expectSameMoves(head + "M98 P100 L0\nG1 Z-1\nM2\n" + cut, folder);
    expectSameMoves(head + "M98 P100\nM98 P200 L2\nM2\nO100\nG1 Z-5\nM98 P200\nM99\nO200\nG91\nG1 X-1\nG90\nM99\n",
                    folder);
    expectSameMoves(head + "#1=3\nM98 P100\nG1 Z#1\nM2\nO100\n#1=-9\nG1 Z#1\nM99\n",
                    folder);  // no variables of its own
    // What it refuses is not taken for understood.
    for (const std::string& program :
         {head + "M98 P300\nM2\n", head + "M98 P100 Q3\nM2\n" + cut, head + "o100 call\nM2\n" + cut,
          head + "M98 P100\nM2\no100 sub\nG1 Z-5\no100 endsub\n", head + "M98 P100\nM2\nO100\nG1 Z-5\nM99 P20\n"}) {
        EXPECT_FALSE(madeByLinuxCnc(program, folder.path(), true)) << program;
        const Toolpath path = pathOf(program, "linuxcnc");
        EXPECT_TRUE(path.has_errors || path.understanding.first() != nullptr) << program;
    }
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
    EXPECT_LT(gaps, cycles);  // a program holds several contours, and most of them have a pocket
    EXPECT_LT(refused, cycles / 2);
    fmt::print("{} programs alike, {} differ; of {} with cycles over contours {} refused by both, {} not modelled\n",
               moved - differ, differ, cycles, refused, gaps);
}

/// One contour without pockets, of lines and of arcs, most of them tangential to the digits of the program.
std::string cycleWithoutPockets(std::uint32_t seed)
{
    std::mt19937 random(seed);
    const auto between = [&random](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    const auto chance = [&](double of) { return between(0, 1) < of; };
    const bool isFace = chance(0.4), isBore = chance(0.3), isBack = chance(0.3), isInch = chance(0.2);
    const double unit = isInch ? 25.4 : 1;
    const int digits = chance(0.5) ? 3 : 1;
    const auto shown = [&](double value) { return fmt::format("{:.{}f}", value / unit, isInch ? 5 : digits); };
    // Along the feed forward, across it upward.
    const auto block = [&](const char* word, double along, double across, const std::string& end) {
        const double feed = isBack ? along : -along, depth = isBore ? 60 - across : across;
        return isFace ? fmt::format("{} X{} Z{}{}\n", word, shown(60 + feed), shown(depth), end)
                      : fmt::format("{} X{} Z{}{}\n", word, shown(depth), shown(feed), end);
    };
    const bool isTurned = (isFace != isBore) != isBack;
    double along = 0, across = between(5, 15);
    std::string contour = block("G1", along, across, "");
    const int pieces = 2 + static_cast<int>(random() % 5);
    bool wasAlong = chance(0.5);
    for (int i = 0; i < pieces; ++i) {
        const double step = std::round(between(1, 6) * 10) / 10;
        const int kind = static_cast<int>(random() % 5);
        if (kind < 2) {  // a line along one of the axes, in turn
            (wasAlong ? across : along) += step;
            wasAlong = !wasAlong;
            contour += block("G1", along, across, "");
        } else if (kind == 2) {
            along += step;
            across += between(0.5, 6);
            contour += block("G1", along, across, "");
        } else {  // a quarter of a circle, hollow or round
            along += step;
            across += step;
            contour +=
                block((kind == 3) != isTurned ? "G2" : "G3", along, across, std::string(" R").append(shown(step)));
            wasAlong = kind == 4;
        }
    }
    const bool isFinish = chance(0.3);
    const double left = chance(0.3) ? 0 : std::round(between(0.1, 0.6) * 20) / 20;
    std::string text = fmt::format("G18 {} G8 G90 G95\nF0.2\nG97 S1000 M3\no100 sub\n{}o100 endsub\n",
                                   isInch ? "G20" : "G21", contour);
    text += block("G0", -between(0.5, 4), across + between(-2, 3), "");
    if (isFinish) return text + fmt::format("G70 Q100 D{} E{} P{}\nM2\n", shown(left), shown(0.1), 1 + random() % 3);
    return text + fmt::format("G{}{} Q100 D{} I{} R{}\nM2\n", isFace ? 72 : 71, chance(0.3) ? ".1" : "", shown(left),
                              shown(std::round(between(0.5, 2.5) * 2) / 2 + 0.1), shown(between(0.2, 1)));
}

TEST(Rs274, CyclesWithoutPocketsMoveAlike)
{
    const ScratchFolder folder;
    const char* soak = std::getenv("LATHELIER_SOAK");  // NOLINT(concurrency-mt-unsafe)
    const int count = soak ? std::atoi(soak) : 60;     // NOLINT(cert-err34-c)
    int alike = 0, refused = 0, gaps = 0;
    for (int i = 1; i <= count; ++i) {
        const std::string program = cycleWithoutPockets(static_cast<std::uint32_t>(i));
        const Toolpath path = pathOf(program, "linuxcnc");
        if (path.understanding.first() != nullptr) {
            ++gaps;
            continue;
        }
        const auto theirs = madeByLinuxCnc(program, folder.path(), true);
        EXPECT_EQ(path.has_errors, !theirs) << "seed " << i << '\n' << program;
        refused += path.has_errors;
        if (path.has_errors || !theirs) continue;
        const std::string why = differenceOf(path.moves, *theirs, limitOf(program));
        EXPECT_EQ(why, "") << "seed " << i << '\n' << program;
        alike += why.empty();
    }
    EXPECT_GT(alike, count / 4);
    fmt::print("{} cycles alike, {} refused by both, {} not modelled\n", alike, refused, gaps);
}

}  // namespace
}  // namespace lathelier::gcode
