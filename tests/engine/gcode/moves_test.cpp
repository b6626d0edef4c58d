// Execution of programs: positions, modes, arcs, corners, cycles, flow, compensation.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/gcode/tool_table.h"
#include "tests/engine/gcode/run_program.h"

namespace lathelier::gcode {
namespace {

/// Moves of both with known end points agree to 1e-9.
void expectTwins(const std::string& fanuc, const std::string& linuxCnc)
{
    const auto known = [](const Toolpath& path) {
        std::vector<Move> moves;
        for (const Move& move : path.moves)
            if (isKnown(move.x_mm) && !(move.kind == MoveKind::Rapid && move.passes_point)) moves.push_back(move);
        return moves;
    };
    const Toolpath one = pathOf(keptProgram(fanuc)), two = pathOf(keptProgram(linuxCnc));
    EXPECT_FALSE(one.has_errors);
    EXPECT_FALSE(two.has_errors);
    std::vector<Move> a = known(one);
    const std::vector<Move> b = known(two);
    if (a.size() > b.size()) a.resize(b.size());  // return moves
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].kind, b[i].kind) << i;
        EXPECT_NEAR(a[i].x_mm, b[i].x_mm, 1e-9) << i;
        EXPECT_NEAR(a[i].z_mm, b[i].z_mm, 1e-9) << i;
        if (a[i].kind != MoveKind::Arc) continue;
        EXPECT_NEAR(a[i].centre_x_mm, b[i].centre_x_mm, 1e-9) << i;
        EXPECT_NEAR(a[i].centre_z_mm, b[i].centre_z_mm, 1e-9) << i;
        EXPECT_EQ(a[i].clockwise, b[i].clockwise) << i;
    }
}

TEST(Moves, TwinsAgree)
{
    expectTwins("caseA_fanuc.nc", "caseA_linuxcnc.ngc");
    expectTwins("contour_fanuc.nc", "contour_linuxcnc.ngc");
}

TEST(Moves, SpeedsAndFeeds)
{
    const Toolpath path =
        pathOf("G21 G99\nG50 S2500\nG96 S200 M4\nG0 X38. Z2.\nG1 Z-5. F.2\nG98 F100.\nX40.\nG97 S800\nZ-6.\n");
    ASSERT_EQ(path.moves.size(), 4u);
    EXPECT_TRUE(std::isnan(path.moves[0].feed_mm_rev));
    EXPECT_EQ(path.moves[1].feed_mm_rev, 0.2);
    EXPECT_EQ(path.moves[1].cutting_speed_m_min, 200);
    EXPECT_EQ(path.moves[1].speed_limit_rpm, 2500);
    EXPECT_TRUE(std::isnan(path.moves[1].speed_rpm));
    EXPECT_EQ(path.moves[2].feed_mm_min, 100);
    EXPECT_EQ(path.moves[3].speed_rpm, 800);
    EXPECT_TRUE(std::isnan(path.moves[3].cutting_speed_m_min));
    const Toolpath inch = pathOf("G20 G99\nG96 S500 M3\nG0 X1. Z.1\nG1 Z-1. F.01\n", "fanuc");
    EXPECT_NEAR(inch.moves[1].z_mm, -25.4, 1e-12);
    EXPECT_NEAR(inch.moves[1].feed_mm_rev, 0.254, 1e-12);
    EXPECT_NEAR(inch.moves[1].cutting_speed_m_min, 152.4, 1e-12);
}

TEST(Moves, IncrementsDiametersAndRadii)
{
    const Toolpath fanuc = pathOf("G0 X20. Z1.\nG1 U4. W-2. F.1\n", "fanuc");
    EXPECT_DOUBLE_EQ(fanuc.moves[1].x_mm, 12);
    EXPECT_DOUBLE_EQ(fanuc.moves[1].z_mm, -1);
    const Toolpath linux = pathOf("G8 G0 X20 Z1\nG7 X30\nG91 X2 Z-1\n", "linuxcnc");
    EXPECT_DOUBLE_EQ(linux.moves[0].x_mm, 20);
    EXPECT_DOUBLE_EQ(linux.moves[1].x_mm, 15);
    EXPECT_DOUBLE_EQ(linux.moves[2].x_mm, 16);
    const Toolpath siemens = pathOf("DIAM90 G90 G0 X20 Z1\nG91 X2\nDIAMON G90 X=IC(2)\nDIAMOF X20\n", "sinumerik");
    EXPECT_DOUBLE_EQ(siemens.moves[1].x_mm, 12);
    EXPECT_DOUBLE_EQ(siemens.moves[2].x_mm, 13);
    EXPECT_DOUBLE_EQ(siemens.moves[3].x_mm, 20);
}

TEST(Moves, ReferencePointsHaveNoCoordinates)
{
    const Toolpath path = pathOf("G0 X20. Z1.\nG28 U0. W0.\nG53 G0 X0. Z-250.\n", "haas");
    ASSERT_EQ(path.moves.size(), 4u);
    EXPECT_DOUBLE_EQ(path.moves[1].x_mm, 10);
    for (const std::size_t i : {2u, 3u}) {
        EXPECT_TRUE(std::isnan(path.moves[i].x_mm));
        EXPECT_TRUE(std::isnan(path.moves[i].z_mm));
    }
}

TEST(Moves, SingleCyclesAreFourMoves)
{
    const Toolpath path = pathOf(
        "G99 F.2\nG0 X40. Z2.\nG90 X36. Z-10.\nX32. R-1.\nG94 X10. Z-1.\nG92 X38. Z-9. F1.5\nG0 X50.\n", "fanuc");
    ASSERT_EQ(path.moves.size(), 1 + 16 + 1u);
    EXPECT_EQ(path.moves[1].line, 3);
    EXPECT_DOUBLE_EQ(path.moves[2].x_mm, 18);
    EXPECT_DOUBLE_EQ(path.moves[5].x_mm, 15);  // R: half a cone
    EXPECT_DOUBLE_EQ(path.moves[6].x_mm, 16);
    EXPECT_DOUBLE_EQ(path.moves[9].z_mm, -1);
    EXPECT_EQ(path.moves[14].kind, MoveKind::Thread);
    EXPECT_EQ(path.moves[14].feed_mm_rev, 1.5);
    EXPECT_DOUBLE_EQ(path.moves[16].z_mm, 2);
}

TEST(Moves, ThreadPassesFollowTheRoot)
{
    const Toolpath path =
        pathOf("G97 S500\nG0 X24. Z6.\nG76 P010060 Q80 R0.03\nG76 X18.16 Z-18. P920 Q250 F1.5\n", "fanuc");
    std::vector<double> depths;
    for (const Move& move : path.moves)
        if (move.kind == MoveKind::Thread) depths.push_back(10 - move.x_mm);
    ASSERT_GE(depths.size(), 4u);
    EXPECT_NEAR(depths[0], 0.25, 1e-9);
    EXPECT_NEAR(depths[1], 0.25 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(depths[depths.size() - 2], 0.92 - 0.03, 1e-9);
    EXPECT_NEAR(depths.back(), 0.92, 1e-9);
    for (std::size_t i = 1; i + 2 < depths.size(); ++i) EXPECT_GE(depths[i] - depths[i - 1], 0.08 - 1e-9);
}

TEST(Moves, RoughingLeavesItsAllowance)
{
    const Toolpath path = pathOf(keptProgram("stepped_g71.nc"));
    EXPECT_FALSE(path.has_errors);
    const auto contour = [](double z) {  // radius of the programmed shape
        if (z > -10) return 10.0;
        if (z > -20) return 10 - (z + 10) / 2;
        if (z > -25) return 20 - std::sqrt(std::max(0.0, 25 - (z + 20) * (z + 20)));
        return z > -40 ? 20.0 : 26.0;
    };
    bool wasRough = false;
    Point from;
    for (const Move& move : path.moves) {
        if (move.line == 10 && move.x_mm < 10.1) break;  // G70 begins
        if (move.kind == MoveKind::Feed && isKnown(from)) {
            wasRough = true;
            for (double t = 0; t <= 1; t += 0.01) {
                const double x = from.x_mm + t * (move.x_mm - from.x_mm), z = from.z_mm + t * (move.z_mm - from.z_mm);
                if (z >= 1.9 || z <= -39.8) continue;
                EXPECT_GE(x, contour(z) + 0.2 - 0.06) << "line " << move.line << " z " << z;
            }
        }
        from = {move.x_mm, move.z_mm};
    }
    EXPECT_TRUE(wasRough);
    EXPECT_DOUBLE_EQ(path.moves.back().x_mm, 50);
}

TEST(Moves, PocketsAreRoughedWithoutARapidThroughStock)
{
    const Toolpath path = pathOf(
        "G0 X40. Z2.\nG71 U2. R.5\nG71 P10 Q20 U0. W0. F.2\nN10 G0 X30. Z2.\nG1 Z-10.\nX20. Z-15.\nZ-25.\nX34. "
        "Z-30.\nN20 Z-40.\nM30\n",
        "fanuc");
    EXPECT_FALSE(path.has_errors);
    double deepest = 100;
    for (const Move& move : path.moves) deepest = std::min(deepest, move.x_mm);
    EXPECT_DOUBLE_EQ(deepest, 10);
}

TEST(Moves, FlowOfAllDialects)
{
    const Toolpath o = pathOf(keptProgram("flow.ngc"));
    ASSERT_EQ(o.moves.size(), 4u);
    EXPECT_DOUBLE_EQ(o.moves.back().x_mm, 49.5);
    const Toolpath s = pathOf(keptProgram("flow.mpf"));
    EXPECT_EQ(s.moves.size(), 12u);
    EXPECT_EQ(s.words, s.words_understood);
    const Toolpath l = pathOf("%_N_A_MPF\nG90 DIAMON G0 X10 Z1\nL5 P2\nM30\n%_N_L5_SPF\nG91 Z-1\nM17\n", "sinumerik");
    EXPECT_FALSE(l.has_errors);
    ASSERT_EQ(l.moves.size(), 3u);
    EXPECT_DOUBLE_EQ(l.moves.back().z_mm, -1);
    EXPECT_TRUE(diagnosticOf(pathOf("G0 X10 Z1\nL7\n", "sinumerik"), "nc_subprogram_missing"));
    const Toolpath f = pathOf(
        "O1\n#1=0\nWHILE[#1 LT 3]DO1\n#1=#1+1\nG0 X[10.*#1] Z1.\nEND1\nIF[#1 EQ 3]GOTO 9\nG0 X1.\nN9 M98 P20002\n"
        "G65 P3 A5. B2.\nM30\nO2\nG0 W-1.\nM99\nO3\nG0 X[#1+#2] Z0.\nM99\n",
        "fanuc");
    EXPECT_FALSE(f.has_errors);
    ASSERT_EQ(f.moves.size(), 6u);
    EXPECT_DOUBLE_EQ(f.moves[2].x_mm, 15);
    EXPECT_DOUBLE_EQ(f.moves[4].z_mm, -1);
    EXPECT_DOUBLE_EQ(f.moves[5].x_mm, 3.5);
}

TEST(Moves, ThreadOfADriveLine)
{
    // Moves of LinuxCNC's interpreter for its G76.
    const Toolpath path = pathOf(
        "G18 G21 G7 G90 G97 S500 M3\nG0 X24 Z3\nG76 P1.5 Z-20 I-2 J0.2 R1.5 K0.92 Q29.5 H1 E1.5 L2\nG0 X50 Z50\n",
        "linuxcnc");
    EXPECT_FALSE(path.has_errors);
    const std::vector<std::pair<double, double>> first{{12, 3},          {12.36, 2.9434},   {10.9, 2.9434},
                                                       {10.9, -18.2963}, {11.36, -19.7963}, {12.36, -19.7963}};
    ASSERT_GT(path.moves.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_NEAR(path.moves[i].x_mm, first[i].first, 1e-4) << i;
        EXPECT_NEAR(path.moves[i].z_mm, first[i].second, 1e-4) << i;
    }
    const Move& last = path.moves[path.moves.size() - 2];  // on the drive line, at its end
    EXPECT_DOUBLE_EQ(last.x_mm, 12);
    EXPECT_DOUBLE_EQ(last.z_mm, -20);
}

TEST(Moves, ALoopOverAWrongBlockEndsSoon)
{
    const Toolpath path = pathOf("#1=0\no1 while [#1 LT 3]\n#2=[#1 +]\no1 endwhile\n", "linuxcnc");
    EXPECT_TRUE(path.has_errors);
    EXPECT_FALSE(diagnosticOf(path, "nc_loop_limit"));  // stopped before the limit of loops
}

TEST(Moves, NoseRadiusCompensation)
{
    const ToolTable tools = readToolTable(keptProgram("tools.tbl"));
    ASSERT_EQ(tools.at(1).corner_radius_mm, 0.8);
    ASSERT_EQ(tools.at(1).tip, 3);
    const Toolpath path = pathOf(keptProgram("compensated.ngc"), automaticControl, {}, tools);
    EXPECT_FALSE(path.has_errors);
    // Along the cylinder the tip runs on it; the 45° cone is met r·(1 - tan 22.5°) early; fillets lose the radius.
    const double early = 0.8 * (1 - std::tan(std::acos(-1.0) / 8));
    bool hasFillet = false;
    for (const Move& move : path.moves) {
        if (move.line == 5) {
            EXPECT_NEAR(move.x_mm, 10, 1e-9);
            EXPECT_NEAR(move.z_mm, -10 - early, 1e-9);
        }
        if (move.line != 8 || move.kind != MoveKind::Arc) continue;
        hasFillet = true;
        EXPECT_NEAR(move.x_mm - 0, 19.2 + 0.0, 1e-9);
        EXPECT_NEAR(std::hypot(move.x_mm - move.centre_x_mm, move.z_mm - move.centre_z_mm), 4.2, 1e-9);
    }
    EXPECT_TRUE(hasFillet);
    const Toolpath unknown = pathOf(keptProgram("compensated.ngc"));
    EXPECT_TRUE(diagnosticOf(unknown, "nose_radius_unknown"));
    EXPECT_DOUBLE_EQ(unknown.moves[1].x_mm, 10);
    ToolpathParameters tight;
    tight.nose_radius_mm = 6;
    EXPECT_TRUE(diagnosticOf(pathOf(keptProgram("compensated.ngc"), automaticControl, tight), "nose_does_not_fit"));
}

TEST(Moves, LengthsScale)
{
    // The same program in inches: every length by 25.4.
    const std::string words =
        "G0 X20. Z1.\nG1 Z-5. F.2 ,R1.\nX30. ,C.5\nZ-9.\nG3 X34. Z-11. R2.\nG90 X30. Z-20. R-1.\n";
    const Toolpath mm = pathOf("G21\n" + words, "fanuc"), inch = pathOf("G20\n" + words, "fanuc");
    ASSERT_EQ(mm.moves.size(), inch.moves.size());
    for (std::size_t i = 0; i < mm.moves.size(); ++i) {
        EXPECT_NEAR(inch.moves[i].x_mm, 25.4 * mm.moves[i].x_mm, 1e-9) << i;
        EXPECT_NEAR(inch.moves[i].z_mm, 25.4 * mm.moves[i].z_mm, 1e-9) << i;
    }
}

}  // namespace
}  // namespace lathelier::gcode
