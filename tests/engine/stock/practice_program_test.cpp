// Complete turning programs: free of collisions, a planted rapid move collides, and results do not depend on the column
// width.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "engine/gcode/toolpath.h"
#include "engine/stock/tool_outline.h"
#include "made_program.h"

namespace lathelier::stock {
namespace {

std::vector<gcode::Move> practice(const std::string& name)
{
    std::ifstream file(LATHELIER_SOURCE_DIR "/tests/data/turning/" + name, std::ios::binary);
    gcode::Program program =
        gcode::readProgram({std::istreambuf_iterator<char>(file), {}}, gcode::controlNamed("fanuc"));
    return gcode::findToolpath(program).moves;
}

Tool insert(int number, double radius_mm, double entering_deg, double tip_deg, double edge_mm, int tip = 3)
{
    Tool tool;
    tool.number = number;
    tool.tip = tip;
    tool.corner_radius_mm = radius_mm;
    tool.entering_angle_deg = entering_deg;
    tool.tip_angle_deg = tip_deg;
    tool.edge_length_mm = edge_mm;
    return tool;
}

/// The tools of all programs, as their jobs state them; the stock stands 1 mm before Z0.
StockParameters job(double chuck_face_z_mm)
{
    Tool groove = blade(2, 18);
    groove.number = 8;
    groove.corner_radius_mm = 0.2;
    StockParameters parameters;
    parameters.z_zero_mm = 1;
    parameters.tools = {insert(1, 0.8, 95, 80, 12), insert(2, 0.4, 95, 80, 9),     insert(3, 0.4, 93, 55, 11),
                        insert(5, 0.8, 93, 55, 15), insert(6, 0.4, 93, 35, 16, 4), groove};
    parameters.chuck = ChuckBody{chuck_face_z_mm + 1, 0};
    return parameters;
}

struct Case {
    const char* file;
    double diameter_mm, chuck_face_z_mm;
};

TEST(PracticeProgram, NoneCollides)
{
    for (const Case& one : {Case{"contour_fanuc_a.nc", 54, 90}, Case{"neck_all_fanuc_a.nc", 32, 150},
                            Case{"paper_s1_fanuc_a.nc", 40, 130}}) {
        const std::vector<gcode::Move> moves = practice(one.file);
        ASSERT_GT(moves.size(), 30U) << one.file;
        const Shaft stock = bar(one.chuck_face_z_mm + 1, one.diameter_mm);
        const StockResult coarse = simulateStock(stock, moves, job(one.chuck_face_z_mm));
        for (const StockFinding& finding : coarse.findings)
            ADD_FAILURE() << one.file << " line " << finding.line << ' ' << key(finding.kind) << ' '
                          << key(finding.path) << " z " << finding.z_mm << " x " << finding.x_mm << " depth "
                          << finding.depth_mm << " width " << finding.width_mm;
        StockParameters parameters = job(one.chuck_face_z_mm);
        parameters.step_mm = 0.005;
        parameters.dog_leg = false;
        const StockResult fine = simulateStock(stock, moves, parameters);
        EXPECT_TRUE(fine.findings.empty()) << one.file;
        const double coarse_mm2 = stock.length_mm() * one.diameter_mm / 2 - coarse.left.area_mm2();
        const double fine_mm2 = stock.length_mm() * one.diameter_mm / 2 - fine.left.area_mm2();
        EXPECT_NEAR(coarse_mm2, fine_mm2, 0.05) << one.file;
    }
}

TEST(PracticeProgram, ThePlantedRapidMoveIsFound)
{
    const StockResult result = simulateStock(bar(131, 40), practice("rapid_into_stock_fanuc_a.nc"), job(130));
    ASSERT_EQ(result.findings.size(), 1U);
    EXPECT_EQ(result.findings[0].line, 22);
    EXPECT_EQ(result.findings[0].kind, FindingKind::RapidThroughStock);
    EXPECT_NEAR(result.findings[0].depth_mm, 1.62, 0.005);
}

TEST(PracticeProgram, WhatIsLeftIsTheContour)
{
    const StockResult result = simulateStock(bar(91, 54), practice("contour_fanuc_a.nc"), job(90));
    EXPECT_FALSE(result.left.outerRadius_mm(0.5));
    for (const auto& [z_mm, radius_mm] : {std::pair{10.0, 10.0}, {26.0, 18.0}, {50.0, 25.0}})
        EXPECT_NEAR(result.left.outerRadius_mm(z_mm + 1).value_or(0), radius_mm, 0.001);
}

TEST(TurningInsert, StandsAtItsImaginaryTip)
{
    const auto boxOfTip = [](int tip) { return boxOf(outlineOf(insert(1, 0.8, 95, 80, 12, tip)).insert); };
    for (const int tip : {3, 4, 8}) EXPECT_NEAR(boxOfTip(tip).low.x_mm, 0, 1e-12);
    for (const int tip : {1, 2, 6}) EXPECT_NEAR(boxOfTip(tip).high.x_mm, 0, 1e-12);
    for (const int tip : {2, 3, 7}) EXPECT_NEAR(boxOfTip(tip).high.z_mm, 0, 1e-12);
    for (const int tip : {1, 4, 5}) EXPECT_NEAR(boxOfTip(tip).low.z_mm, 0, 1e-12);
    EXPECT_NEAR(boxOfTip(0).low.x_mm, -0.8, 1e-12);
    EXPECT_NEAR(boxOfTip(8).low.z_mm, -boxOfTip(8).high.z_mm, 1e-9);
    EXPECT_TRUE(outlineOf(Tool()).is_assumed);
    EXPECT_FALSE(outlineOf(insert(1, 0.8, 95, 80, 12)).is_assumed);
    Tool named;
    named.name = "DNMG 150608 / PDJNL";
    EXPECT_EQ(outlineOf(named).tip_angle_deg, 55);
    EXPECT_FALSE(tipAngleOfCode_deg("PDJNL 2525"));
    EXPECT_THROW(outlineOf(insert(1, 0.8, 105, 80, 12)), Error);
    EXPECT_THROW(outlineOf(insert(1, 20, 95, 80, 12)), Error);
}

}  // namespace
}  // namespace lathelier::stock
