// What a program states that is not modelled: no moves, and a gap that says so.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "tests/engine/gcode/run_program.h"

namespace lathelier::gcode {
namespace {

bool hasGap(const Toolpath& path, std::int64_t line, GapEffect effect)
{
    for (const NotModelled& gap : path.understanding.not_modelled)
        if (gap.line == line && gap.effect == effect) return true;
    return false;
}

struct Gap {
    const char* control;
    const char* text;  ///< moves to X20 Z2 first
    std::int64_t line;
    GapEffect effect;
    std::size_t moves;
};

TEST(Understanding, WordsThatMayOwnTheCoordinatesMakeNoMove)
{
    const Gap all[] = {
        {"fanuc", "G0 X40. Z2.\nG160 Z-5.\nM30\n", 2, GapEffect::Moves, 1},
        {"fanuc", "G0 X40. Z2.\nG300 X11.\nM30\n", 2, GapEffect::Moves, 1},
        {"fanuc", "G0 X40. Z2.\nG160\nX30.\nM30\n", 2, GapEffect::Moves, 2},
        {"fanuc", "G0 X40. Z2.\nG68 X5.\nM30\n", 2, GapEffect::Moves, 1},
        {"fanuc", "G0 X40. Z2.\nM98 P77\nM30\n", 2, GapEffect::Moves, 1},
        {"fanuc", "G0 X40. Z2.\nG65 P9010 A2. B3.\nM30\n", 2, GapEffect::Moves, 1},
        {"fanuc", "G0 X40. Z2.\nM400\nG0 X30.\nM30\n", 2, GapEffect::None, 2},
        {"fanuc", "G0 X40. Z2.\nM400 X30.\nM30\n", 2, GapEffect::Moves, 1},
        {"fanuc", "G0 X40. Z2.\nM400 P3\nM30\n", 2, GapEffect::Moves, 1},
        {"fanuc", "G0 X40. Z2. C0.\nM3 S900\nG83 Z-1. R2. F.1\nC90.\nG80\nM30\n", 4, GapEffect::Moves, 4},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nCYCLE999(1,2)\nG0 X30\nM30\n", 2, GapEffect::Moves, 2},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nSCHRUPP\nM30\n", 2, GapEffect::Moves, 1},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nL54\nM30\n", 2, GapEffect::Moves, 1},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nFOO X30\nM30\n", 2, GapEffect::Moves, 1},
        {"linuxcnc", "G7 G0 X40 Z2\no<away> call\nM2\n", 2, GapEffect::Moves, 1},
        {"linuxcnc", "G7 G0 X40 Z2\nG38.2 X30\nM2\n", 2, GapEffect::Moves, 1},
    };
    for (const Gap& one : all) {
        const Toolpath path = pathOf(one.text, one.control);
        EXPECT_FALSE(path.has_errors) << one.text;
        EXPECT_TRUE(hasGap(path, one.line, one.effect)) << one.text;
        EXPECT_EQ(path.understanding.isWhole(), one.effect == GapEffect::None) << one.text;
        EXPECT_EQ(path.moves.size(), one.moves) << one.text;
    }
}

TEST(Understanding, MovesOfDrivenToolsAreNoTurningMoves)
{
    const char* const milled[] = {
        "G0 X40. Z2.\nG112\nG1 X26. C5. F100.\nX20. C0.\nG113\nG0 X40.\nM30\n",
        "G0 X40. Z2.\nG12.1\nG1 X26. F100.\nG13.1\nG0 X40.\nM30\n",
        "G0 X40. Z2. C0.\nG1 Z-5. F.1\nG0 Z2.\nM30\n",
        "G0 X40. Z2.\nG1 X30. Y5. F.1\nG0 X40.\nM30\n",
        "G0 X40. Z2.\nG17\nG1 X30. F.1\nG18\nG0 X40.\nM30\n",
        "G0 X40. Z2.\nG19\nG1 Z-5. F.1\nG18\nG0 X40.\nM30\n",
        "G0 X40. Z2.\nC90.\nG83 Z-10. Q3000 F.1\nG80\nM30\n",
    };
    for (const char* const text : milled) {
        const Toolpath path = pathOf(text, "fanuc");
        EXPECT_FALSE(path.understanding.isWhole()) << text;
        for (const Move& move : path.moves) EXPECT_EQ(move.kind, MoveKind::Rapid) << text;
    }
    const char* const turned[] = {
        "G28 U0. W0.\nG28 H0.\nG0 X40. Z2.\nG97 S500 M3\nG1 Z-5. F.1\nM30\n",
        "G0 X40. Z2. C0.\nM3 S500\nG1 Z-5. F.1\nM30\n",
        "G0 Y0. X40. Z2.\nG1 Z-5. F.1\nM30\n",
        "G17\nG18\nG0 X40. Z2.\nG1 Z-5. F.1\nM30\n",
    };
    for (const char* const text : turned) EXPECT_TRUE(pathOf(text, "fanuc").understanding.isWhole()) << text;
}

TEST(Understanding, ShiftsAndFramesAreFollowed)
{
    struct Shifted {
        const char* control;
        const char* text;
        double x_mm, z_mm;  ///< end of the last move
    };
    const Shifted all[] = {
        {"fanuc", "G0 X40. Z2.\nG52 Z-5.\nG0 Z0.\nM30\n", 20, -5},
        {"fanuc", "G0 X40. Z2.\nG52 X-2. Z-5.\nG0 X40. Z0.\nM30\n", 19, -5},
        {"fanuc", "G0 X40. Z2.\nG52 Z-5.\nG52 Z0.\nG0 Z1.\nM30\n", 20, 1},
        {"fanuc", "G0 X40. Z2.\nG52 Z-5.\nG0 W-1.\nM30\n", 20, 1},
        {"fanuc", "G10 L2 P1 Z-5.\nG0 X40. Z2.\nM30\n", 20, -3},
        {"fanuc", "G54\nG10 L2 P1 Z-5.\nG10 L2 P2 Z-7.\nG0 X40. Z2.\nG55\nG0 Z0.\nM30\n", 20, -7},
        {"linuxcnc", "G7 G0 X40 Z2\nG92 Z7\nG0 Z0\nM2\n", 20, -5},
        {"linuxcnc", "G7 G0 X40 Z2\nG92 Z7\nG92.1\nG0 Z0\nM2\n", 20, 0},
        {"linuxcnc", "G7 G0 X40 Z2\nG10 L2 P0 X4\nG0 X40\nM2\n", 22, 2},
        {"linuxcnc", "G7 G0 X40 Z2\nG10 L2 P7 Z-3\nG59.1 G0 Z0\nM2\n", 20, -3},
        {"linuxcnc", "G7 G0 X40 Z2\nG92 Z7\nG92.2\nG92.3\nG0 Z0\nM2\n", 20, -5},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nTRANS Z=-5\nZ0\nM30\n", 20, -5},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nTRANS X-2 Z-5\nX40 Z0\nM30\n", 19, -5},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nTRANS Z-5\nATRANS Z-1\nZ0\nM30\n", 20, -6},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nTRANS Z-5\nTRANS\nZ0\nM30\n", 20, 0},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nTRANS Z-5\nMIRROR Z0\nZ3\nM30\n", 20, -3},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nTRANS Z-5\nAMIRROR Z0\nZ3\nM30\n", 20, -8},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nSCALE X2 Z2\nX30 Z-5\nM30\n", 30, -10},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nG158 Z-5\nZ0\nM30\n", 20, -5},
        {"sinumerik", "G90 DIAMON G0 X40 Z2\nG58 Z-5\nG59 Z-1\nZ0\nM30\n", 20, -6},
        {"sinumerik", "G90 DIAMON G0 X0 Z0\nROT RPL=30\nX0 Z10\nM30\n", 5, 10 * 0.86602540378443865},
    };
    for (const Shifted& one : all) {
        const Toolpath path = pathOf(one.text, one.control);
        EXPECT_TRUE(path.understanding.isWhole()) << one.text;
        ASSERT_FALSE(path.moves.empty()) << one.text;
        EXPECT_NEAR(path.moves.back().x_mm, one.x_mm, 1e-9) << one.text;
        EXPECT_NEAR(path.moves.back().z_mm, one.z_mm, 1e-9) << one.text;
    }
    const Toolpath unknown = pathOf("G54\nG0 X40. Z2.\nG55\nG0 Z0.\nM30\n", "fanuc");
    EXPECT_TRUE(hasGap(unknown, 3, GapEffect::Shifts));
}

TEST(Understanding, ArcsFollowTheFrame)
{
    const Toolpath path =
        pathOf("G90 DIAMON G18 G0 X40 Z0\nTRANS Z-10\nMIRROR Z0\nG0 X40 Z0\nG3 X50 Z5 CR=5 F0.1\nM30\n", "sinumerik");
    ASSERT_FALSE(path.has_errors);
    const Move& arc = path.moves.back();
    EXPECT_TRUE(arc.clockwise);
    EXPECT_NEAR(arc.z_mm, -5, 1e-12);
    EXPECT_NEAR(std::hypot(arc.centre_x_mm - arc.x_mm, arc.centre_z_mm - arc.z_mm), 5, 1e-9);
}

TEST(Understanding, VariablesWithoutAValueAreNoZeros)
{
    for (const char* const text : {"G0 X50. Z2.\nG0 X[#500+2.]\nM30\n", "G0 X50. Z2.\nG0 X#2001\nM30\n",
                                   "G0 X50. Z2.\n#1=#4006\nG0 Z[#1]\nM30\n", "G0 X50. Z2.\nG0 Z[#5021-1.]\nM30\n"}) {
        const Toolpath path = pathOf(text, "fanuc");
        EXPECT_TRUE(diagnosticOf(path, "nc_variable_not_known")) << text;
    }
    EXPECT_TRUE(diagnosticOf(pathOf("G7 G0 X10 Z2\nG0 X#<nosuch>\nM2\n", "linuxcnc"), "nc_variable_not_known"));
    EXPECT_TRUE(diagnosticOf(pathOf("G90 DIAMON G0 X40 Z2\nX=R7\nM30\n", "sinumerik"), "nc_variable_not_known"));
    // Which way the program goes is not known.
    EXPECT_FALSE(pathOf("G0 X50. Z2.\nIF[#500 EQ 1]GOTO 10\nG0 X40.\nN10 M30\n", "fanuc").understanding.isWhole());
    EXPECT_FALSE(pathOf("G0 X50. Z2. F.1\nG1 Z-5. F#500\nM30\n", "fanuc").understanding.isWhole());
    // A local one that was not given is left out, as the control does.
    const Toolpath vacant = pathOf("G0 X50. Z2.\nG0 X#3 Z1.\nM30\n", "fanuc");
    EXPECT_TRUE(vacant.understanding.isWhole());
    EXPECT_DOUBLE_EQ(vacant.moves.back().x_mm, 25);
}

TEST(Understanding, PositionsAreKnownToTheReader)
{
    const auto lastX = [](const char* text, const char* control) { return pathOf(text, control).moves.back().x_mm; };
    const auto lastZ = [](const char* text, const char* control) { return pathOf(text, control).moves.back().z_mm; };
    EXPECT_DOUBLE_EQ(lastX("G0 X50. Z2.\n#1=#5041\nG0 X[#1+2.]\nM30\n", "fanuc"), 26);
    EXPECT_DOUBLE_EQ(lastZ("G0 X50. Z2.\nG0 Z[#5002-3.]\nM30\n", "fanuc"), -1);
    EXPECT_DOUBLE_EQ(lastX("G7 G0 X50 Z2\nG0 X[#5420+2]\nM2\n", "linuxcnc"), 13.5);
    EXPECT_DOUBLE_EQ(lastX("G7 G0 X27 Z2\nG0 X[#<_x>+4]\nM2\n", "linuxcnc"), 8.75);
}

TEST(Understanding, DeclaredVariablesAndProgramsOfSinumerik)
{
    const Toolpath values = pathOf(
        "DEF REAL DIA=50, LEN\nDEF INT I\nG90 DIAMON G0 X60 Z2\nLEN=DIA/2\nFOR I=1 TO "
        "3\nX=DIA-I*2\nENDFOR\nZ=LEN\nM30\n",
        "sinumerik");
    EXPECT_TRUE(values.understanding.isWhole());
    ASSERT_EQ(values.moves.size(), 5u);
    EXPECT_DOUBLE_EQ(values.moves[1].x_mm, 24);
    EXPECT_DOUBLE_EQ(values.moves[3].x_mm, 22);
    EXPECT_DOUBLE_EQ(values.moves[4].z_mm, 25);

    const Toolpath called = pathOf(
        "N10 G18 G90 G95 DIAMON G97 S500 M3\nG0 X50 Z2\nCALL \"STUFE\"\nSTUFE "
        "P2\nSTUFE2(40,-8)\nM30\n%_N_STUFE_SPF\nG91 "
        "G1 X-2 F0.2\nG90\nRET\n%_N_STUFE2_SPF\nPROC STUFE2(REAL D1,REAL Z1)\nG1 X=D1 Z=Z1\nM17\n",
        "sinumerik");
    EXPECT_TRUE(called.understanding.isWhole());
    ASSERT_EQ(called.moves.size(), 5u);
    EXPECT_DOUBLE_EQ(called.moves[1].x_mm, 24);
    EXPECT_DOUBLE_EQ(called.moves[3].x_mm, 22);
    EXPECT_DOUBLE_EQ(called.moves[4].x_mm, 20);
    EXPECT_DOUBLE_EQ(called.moves[4].z_mm, -8);
}

TEST(Understanding, LinesByTheirAngles)
{
    struct Angled {
        const char* control;
        const char* text;
        std::vector<std::pair<double, double>> ends;  ///< radius, z of the feed moves
    };
    const double tan30 = std::tan(30 * rad_per_deg);
    const Angled all[] = {
        {"fanuc",
         "G0 X20. Z0.\nG1 Z-20. F.2\nX40. A150.\nZ-60.\nM30\n",
         {{10, -20}, {20, -20 - 10 / tan30}, {20, -60}}},
        {"fanuc",
         "G0 X20. Z0.\nG1 Z-10. F.2\nX40. ,A150.\nA180. Z-30.\n,A135. X50.\nM30\n",
         {{10, -10}, {20, -10 - 10 / tan30}, {20, -30}, {25, -35}}},
        {"fanuc",
         "G0 X20. Z0.\nG1 A180. F.2\nX40. Z-30. A150.\nZ-40.\nM30\n",
         {{10, -30 + 10 / tan30}, {20, -30}, {20, -40}}},
        {"sinumerik", "G90 DIAMON G95 G0 X20 Z0\nG1 Z-20 F.2\nX40 ANG=150\nM30\n", {{10, -20}, {20, -20 - 10 / tan30}}},
        {"fanuc",
         "G0 X20. Z0.\nG1 Z-20. I2. F.2\nX40. K-1.\nZ-45.\nM30\n",
         {{10, -18}, {12, -20}, {19, -20}, {20, -21}, {20, -45}}},
        {"fanuc", "G0 X20. Z0.\nG1 Z-20. C2. F.2\nX40.\nM30\n", {{10, -18}, {12, -20}, {20, -20}}},
    };
    for (const Angled& one : all) {
        const Toolpath path = pathOf(one.text, one.control);
        EXPECT_FALSE(path.has_errors) << one.text;
        EXPECT_TRUE(path.understanding.isWhole()) << one.text;
        std::vector<std::pair<double, double>> ends;
        for (const Move& move : path.moves)
            if (move.kind == MoveKind::Feed) ends.emplace_back(move.x_mm, move.z_mm);
        ASSERT_EQ(ends.size(), one.ends.size()) << one.text;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            EXPECT_NEAR(ends[i].first, one.ends[i].first, 1e-9) << one.text << i;
            EXPECT_NEAR(ends[i].second, one.ends[i].second, 1e-9) << one.text << i;
        }
    }
    EXPECT_TRUE(pathOf("G0 X20. Z0.\nG1 A180. F.2\nX40.\nM30\n", "fanuc").has_errors);
    EXPECT_TRUE(pathOf("G0 X20. Z0.\nG1 X40. A180. F.2\nM30\n", "fanuc").has_errors);
    EXPECT_TRUE(pathOf("G0 X20. Z0.\nG1 X40. Z-10. A100. F.2\nM30\n", "fanuc").has_errors);
}

TEST(Understanding, RepeatedParts)
{
    const auto moves = [](const std::string& repeat) {
        return pathOf("G90 G18 DIAMON\nG95 G97 S500 M3\nAA: G0 X10\nG0 X20\n" + repeat + "\nM30\n", "sinumerik")
            .moves.size();
    };
    EXPECT_EQ(moves("REPEAT AA P=3"), 8u);
    EXPECT_EQ(moves("REPEAT AA P3"), 8u);
    EXPECT_EQ(moves("REPEAT AA"), 4u);
    EXPECT_EQ(moves("REPEATB AA P=2"), 4u);
    EXPECT_EQ(moves("BB: G0 X30\nREPEAT AA BB P=1"), 6u);
    EXPECT_TRUE(
        diagnosticOf(pathOf("G90 DIAMON\nAA: G0 X10\nREPEAT AA P=1000000000\nM30\n", "sinumerik"), "nc_loop_limit"));
    EXPECT_TRUE(diagnosticOf(pathOf("G90 DIAMON G0 X10\nREPEAT CC P=2\nM30\n", "sinumerik"), "nc_sequence_missing"));
}

TEST(Understanding, StatementsWithoutTheirEndAreErrors)
{
    struct Open {
        const char* control;
        const char* text;
        std::int64_t line;
    };
    const Open all[] = {{"fanuc", "#1=1\nWHILE[#1 LT 2]DO1\n#1=3\nM30\n", 2},
                        {"fanuc", "G0 X1. Z1.\nEND1\nM30\n", 2},
                        {"fanuc", "WHILE[1 LT 2]DO1\nWHILE[1 LT 2]DO2\nEND1\nM30\n", 2},
                        {"sinumerik", "G90\nWHILE R1<2\nM30\n", 2},
                        {"sinumerik", "G90\nIF 1==1\nM30\n", 2},
                        {"sinumerik", "G90\nENDLOOP\nM30\n", 2}};
    for (const Open& one : all) {
        const Toolpath path = pathOf(one.text, one.control);
        const Diagnostic* const found = diagnosticOf(path, "nc_flow_unmatched");
        ASSERT_TRUE(found) << one.text;
        EXPECT_EQ(found->line, one.line) << one.text;
    }
}

TEST(Understanding, FaultsThatWouldChangeTheAnswerAreErrors)
{
    struct Fault {
        const char* text;
        const char* code;
        std::int64_t line;
    };
    const Fault all[] = {
        {"G0 X50. Z2. F.1\nG71 U0.4 W0.1\nN10 G0 X30.\nN20 G1 Z-9.\nM30\n", "nc_cycle_incomplete", 2},
        {"G0 X50. Z2. F.1\nG73 U10. W1. R999999999\nG73 P10 Q20\nN10 G0 X30.\nN20 G1 Z-9.\nM30\n", "nc_pass_limit", 2},
        {"G0 X50. Z5.\nG76 P010060 Q1 R0.\nG76 X10. Z-1000. P20000 Q1 F0.01\nM30\n", "nc_pass_limit", 3},
        {"G0 X50. Z2. F.1\nG71 U2. R1.\nG71 P10 Q20 U.4\nN10 G0 X30.\nN20 G1 Z-9.\nG70 P10 Q20\nN10 G0 X20.\nN20 "
         "G1 Z-5.\nM30\n",
         "nc_sequence_twice", 3},
        {"G0 X9223372036854775808. Z2.\nM30\n", "nc_coordinate_too_large", 1},
        {"%\n(nothing)\n%\n", "nc_program_empty", 1},
    };
    for (const Fault& one : all) {
        const Toolpath path = pathOf(one.text, "fanuc");
        const Diagnostic* const found = diagnosticOf(path, one.code);
        ASSERT_TRUE(found) << one.text << (path.diagnostics.empty() ? "" : path.diagnostics.front().code);
        EXPECT_TRUE(found->is_error) << one.text;
        EXPECT_EQ(found->line, one.line) << one.text;
    }
}

TEST(Understanding, WhatIsAssumedIsListed)
{
    const auto whatOf = [](const Toolpath& path) {
        std::string all;
        for (const Assumed& one : path.understanding.assumed) all += one.what + "=" + one.value + ";";
        return all;
    };
    EXPECT_EQ(whatOf(pathOf("G0 X40. Z2.\nG1 Z-5. F.1\nM30\n", "fanuc")), "unit=mm;feed=mm/rev;");
    EXPECT_EQ(whatOf(pathOf("G21 G99\nG0 X40. Z2.\nG1 Z-5. F.1\nM30\n", "fanuc")), "");
    EXPECT_EQ(whatOf(pathOf("G21\nG0 X40 Z2\nG1 Z-5 F100\nM2\n", "linuxcnc")),
              "diameter_or_radius=radius;feed=mm/min;");
    EXPECT_EQ(whatOf(pathOf("G21 G7 G94\nG0 X40 Z2\nG1 Z-5 F100\nM2\n", "linuxcnc")), "");
}

/// A word that a program uses is removed from the description of its control: no answer changes without a gap.
TEST(Understanding, AControlThatLacksAWordNeverAnswersInSilence)
{
    struct Case {
        const char* control;
        const char* text;
    };
    const Case cases[] = {
        {"fanuc",
         "O1\nG21 G99 G97 S500 M3 T0101\nG0 X50. Z2.\nG90 X44. Z-20. F.2\nX42.\nG0 X40.\nG52 Z-1.\nG1 Z-5. F.1\nG2 "
         "X44. Z-7. R2.\nG52 Z0.\nG1 U2. W-1.\nG71 U2. R1.\nG71 P10 Q20 U.4 W.1 F.2\nN10 G0 X30.\nN20 G1 Z-10.\nG70 "
         "P10 "
         "Q20\nM98 P2\nG28 U0. W0.\nM30\nO2\nG0 X30.\nM99\n"},
        {"sinumerik",
         "G18 G90 G95 G71 DIAMON G97 S500 M3\nT1 D1\nG0 X50 Z2\nTRANS Z-1\nG1 Z-5 F0.2\nG2 X54 Z-7 CR=2\nTRANS\nG91 G1 "
         "X2\nG90\nG33 Z-20 K1.5\nG0 X60\nM30\n"},
        {"linuxcnc",
         "G21 G7 G90 G95 G18 G97 S500 M3\nT1 M6\nG0 X50 Z2\nG92 Z3\nG1 Z-5 F0.2\nG2 X54 Z-7 R2\nG92.1\nG91 G1 "
         "X2\nG90\nG76 P1 Z-20 I-1 J0.3 K1 R1 Q29 E0 L0\nG0 X60\nM2\n"}};
    const auto same = [](const Toolpath& a, const Toolpath& b) {
        const auto equal = [](double p, double q) { return p == q || (std::isnan(p) && std::isnan(q)); };
        if (a.moves.size() != b.moves.size()) return false;
        for (std::size_t i = 0; i < a.moves.size(); ++i) {
            const Move &m = a.moves[i], &n = b.moves[i];
            if (m.kind != n.kind || m.clockwise != n.clockwise || !equal(m.x_mm, n.x_mm) || !equal(m.z_mm, n.z_mm) ||
                !equal(m.feed_mm_rev, n.feed_mm_rev) || !equal(m.speed_rpm, n.speed_rpm) || m.tool != n.tool)
                return false;
        }
        return true;
    };
    for (const Case& one : cases) {
        const ControlPtr usual = controlNamed(one.control);
        const auto run = [&](const ControlPtr& control) {
            Program program = readProgram(one.text, control);
            return findToolpath(program);
        };
        const Toolpath whole = run(usual);
        ASSERT_FALSE(whole.has_errors) << one.control << " " << sentence(whole.diagnostics.front());
        ASSERT_TRUE(whole.understanding.isWhole()) << one.control << " " << whole.understanding.first()->word;
        const auto check = [&](const std::string& gone, const std::function<void(Control&)>& change) {
            const auto without = std::make_shared<Control>(*usual);
            change(*without);
            const Toolpath path = run(without);
            EXPECT_TRUE(path.has_errors || !path.understanding.isWhole() || same(path, whole))
                << one.control << ": without " << gone << " the moves differ and nothing says so";
        };
        for (const auto& [code, meaning] : usual->g)
            check(fmt::format("G{}", code / 10.0), [code = code](Control& c) { c.g.erase(code); });
        for (const auto& [code, meaning] : usual->m)
            check(fmt::format("M{}", code), [code = code](Control& c) { c.m.erase(code); });
        for (const auto& [letter, use] : usual->letters)
            check(std::string(1, letter), [letter = letter](Control& c) { c.letters.erase(letter); });
        for (const auto& [name, meaning] : usual->names)
            check(name, [&name = name](Control& c) { c.names.erase(name); });
    }
}

}  // namespace
}  // namespace lathelier::gcode
