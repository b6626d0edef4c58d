// Random programs against the interpreter of LinuxCNC. Built only if rs274 is installed.
#include <gtest/gtest.h>

#ifdef LATHELIER_RS274

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "tests/engine/gcode/rs274_moves.h"
#include "tests/engine/gcode/run_program.h"
#include "tests/scratch_folder.h"

namespace lathelier::gcode {
namespace {

/// Generates random blocks and tracks the tool position.
class RandomProgram {
public:
    explicit RandomProgram(std::uint32_t seed) : random_(seed) {}

    std::string text()
    {
        const bool isInch = chance(0.3);
        unit_mm_ = isInch ? 25.4 : 1;
        text_ = fmt::format("G18 {} G7 G90 G91.1 G95 F0.1\nG97 S1000 M3\n", isInch ? "G20" : "G21");
        line("G0", 40, 2);
        for (int i = 0; i < 40; ++i) block();
        text_ += "M2\n";
        return text_;
    }

private:
    bool chance(double share) { return std::uniform_real_distribution<>(0, 1)(random_) < share; }
    double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
    /// Rounded to the resolution of a program.
    double rounded(double mm) const { return std::round(mm / unit_mm_ * 1e5) / 1e5 * unit_mm_; }
    double wordOfX(double x_mm) const
    {
        return ((isIncremental_ ? x_mm - x_mm_ : x_mm) * (isDiameter_ ? 2 : 1)) / unit_mm_;
    }
    double wordOfZ(double z_mm) const { return (isIncremental_ ? z_mm - z_mm_ : z_mm) / unit_mm_; }
    static std::string number(double value) { return fmt::format("{:.7f}", value); }

    void block()
    {
        if (chance(0.15)) text_ += (isDiameter_ = !isDiameter_) ? "G7\n" : "G8\n";
        if (chance(0.15)) text_ += (isIncremental_ = !isIncremental_) ? "G91\n" : "G90\n";
        const double x_mm = rounded(between(5, 60)), z_mm = rounded(between(-100, 5));
        const double choice = between(0, 1);
        if (choice < 0.2)
            line("G0", x_mm, z_mm);
        else if (choice < 0.5)
            line("G1", x_mm, z_mm);
        else if (choice < 0.6)
            expression(x_mm, z_mm);
        else if (choice < 0.65)
            repeated();
        else if (choice < 0.8)
            arcByRadius(x_mm, z_mm);
        else
            arcByCentre();
    }

    void line(const char* word, double x_mm, double z_mm)
    {
        const bool hasX = chance(0.8) || x_mm_ == 0;
        const bool hasZ = !hasX || chance(0.8) || x_mm_ == 0;
        text_ += word;
        if (hasX) text_ += fmt::format(" X{}", number(wordOfX(x_mm)));
        if (hasZ) text_ += fmt::format(" Z{}", number(wordOfZ(z_mm)));
        text_ += "\n";
        if (hasX) x_mm_ = x_mm;
        if (hasZ) z_mm_ = z_mm;
    }

    void expression(double x_mm, double z_mm)
    {
        text_ += fmt::format("#1={} #<share>=[1/3]\n", number(wordOfZ(z_mm)));
        text_ += fmt::format("G1 X[{}*#<share>*3+sin[180]] Z[#1 - [2**3 - 8.0]]\n", number(wordOfX(x_mm)));
        x_mm_ = x_mm;
        z_mm_ = z_mm;
    }

    void repeated()
    {
        const int times = static_cast<int>(between(1, 5));
        const double step_mm = rounded(0.5);
        const int number_of = ++loops_;
        text_ += fmt::format("G91\no{0} repeat [{1}]\nG1 X{2}\no{0} endrepeat\n{3}\n", number_of, times,
                             number(step_mm / unit_mm_ * (isDiameter_ ? 2 : 1)), isIncremental_ ? "G91" : "G90");
        x_mm_ += times * step_mm;
    }

    void arcByRadius(double x_mm, double z_mm)
    {
        const double chord_mm = std::hypot(x_mm - x_mm_, z_mm - z_mm_);
        if (chord_mm < 0.5) return line("G1", x_mm, z_mm);
        const double radius_mm = chord_mm * between(0.51, 3) * (chance(0.3) ? -1 : 1);
        text_ += fmt::format("{} X{} Z{} R{}\n", chance(0.5) ? "G2" : "G3", number(wordOfX(x_mm)),
                             number(wordOfZ(z_mm)), number(radius_mm / unit_mm_));
        x_mm_ = x_mm;
        z_mm_ = z_mm;
    }

    /// I along X as a radius, K along Z, from the start, or with G90.1 from the origin.
    void arcByCentre()
    {
        const double radius_mm = between(1, 20), start = between(-3, 3), sweep = between(-3, 3);
        const double centre_x_mm = x_mm_ - radius_mm * std::sin(start);
        const double centre_z_mm = z_mm_ - radius_mm * std::cos(start);
        const double x_mm = centre_x_mm + radius_mm * std::sin(start + sweep);
        const double z_mm = centre_z_mm + radius_mm * std::cos(start + sweep);
        text_ +=
            fmt::format("{} X{} Z{} I{} K{}\n", chance(0.5) ? "G2" : "G3", number(wordOfX(x_mm)), number(wordOfZ(z_mm)),
                        number((centre_x_mm - x_mm_) / unit_mm_), number((centre_z_mm - z_mm_) / unit_mm_));
        x_mm_ = x_mm;
        z_mm_ = z_mm;
    }

    std::mt19937 random_;
    std::string text_;
    double unit_mm_ = 1, x_mm_ = 0, z_mm_ = 0;
    bool isDiameter_ = true, isIncremental_ = false;
    int loops_ = 100;
};

void expectSameMoves(const std::string& program, const ScratchFolder& folder)
{
    const Toolpath path = pathOf(program, "linuxcnc");
    ASSERT_FALSE(path.has_errors) << program;
    std::vector<Move> ours = path.moves;
    std::erase_if(ours, [](const Move& move) { return move.kind == MoveKind::Dwell; });
    for (Move& move : ours)
        if (move.kind == MoveKind::Thread) move.kind = MoveKind::Feed;  // printed as a feed between synchronisations
    const std::vector<Move> theirs = movesOfLinuxCnc(program, folder.path());
    ASSERT_EQ(ours.size(), theirs.size()) << program;
    const double limit_mm = program.find("G20") == std::string::npos ? 1e-4 : 1e-4 * 25.4;  // four digits are printed
    for (std::size_t i = 0; i < theirs.size(); ++i) {
        SCOPED_TRACE(fmt::format("move {} of line {} of\n{}", i, ours[i].line, program));
        ASSERT_EQ(ours[i].kind, theirs[i].kind);
        ASSERT_NEAR(ours[i].x_mm, theirs[i].x_mm, limit_mm);
        ASSERT_NEAR(ours[i].z_mm, theirs[i].z_mm, limit_mm);
        if (theirs[i].kind != MoveKind::Arc) continue;
        ASSERT_NEAR(ours[i].centre_x_mm, theirs[i].centre_x_mm, limit_mm);
        ASSERT_NEAR(ours[i].centre_z_mm, theirs[i].centre_z_mm, limit_mm);
        ASSERT_EQ(ours[i].clockwise, theirs[i].clockwise);
    }
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
    for (std::uint32_t seed = 1; seed <= 40 && !HasFatalFailure(); ++seed)
        expectSameMoves(RandomProgram(seed).text(), folder);
}

}  // namespace
}  // namespace lathelier::gcode

#endif
