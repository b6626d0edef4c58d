// Times, the drawn path, and the check of a program as a whole.
#include "engine/stock/program_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/stock/stock_codes.h"

namespace lathelier::stock {
namespace {

using gcode::Move;
using gcode::MoveKind;

Move moveTo(MoveKind kind, double x_mm, double z_mm, std::int64_t line)
{
    Move move;
    move.kind = kind;
    move.x_mm = x_mm;
    move.z_mm = z_mm;
    move.line = line;
    move.tool = 1;
    return move;
}

CheckedStock barOf(double diameter_mm, double length_mm)
{
    CheckedStock stock;
    stock.shaft.segments = {ShaftSegment{}};
    ShaftSegment& bar = stock.shaft.segments.front();
    bar.length_mm = length_mm;
    bar.start_diameter_mm = bar.end_diameter_mm = diameter_mm;
    return stock;
}

constexpr const char* twoPasses =
    "%\nO1\nG21 G40 G99\nT0101\nG50 S3000\nG97 S1000 M3\nG0 X40. Z2.\nX30.\nG1 Z-50. F0.2\nX36.\nG0 Z2.\nX28.\nG1 "
    "Z-20.\nX40.\nG0 X100. Z100.\nM30\n%\n";

}  // namespace

TEST(ProgramTimes, FacingAtConstantSurfaceSpeed)
{
    // t = ∫ 2πx dx / (1000 v f) = π (x1² - x0²) / (1000 v f) min from 30 mm radius to 10 mm.
    Move start = moveTo(MoveKind::Rapid, 30, 0, 1), face = moveTo(MoveKind::Feed, 10, 0, 2);
    face.feed_mm_rev = 0.25;
    face.cutting_speed_m_min = 200;
    const std::vector<Move> moves{start, face};
    const double minutes = std::numbers::pi * (900 - 100) / (1000 * 200 * 0.25);
    EXPECT_NEAR(gcode::timesOf(moves).all.feed_time_s, 60 * minutes, 1e-9);

    // With a limit the spindle is not faster than that within x = 1000 v / (2π n).
    std::vector<Move> limited = moves;
    limited[1].speed_limit_rpm = 1500;
    limited[1].x_mm = 0;
    const double x = 1000 * 200 / (2 * std::numbers::pi * 1500);
    const double expected = std::numbers::pi * (900 - x * x) / (1000 * 200 * 0.25) + x / (1500 * 0.25);
    EXPECT_NEAR(gcode::timesOf(limited).all.feed_time_s, 60 * expected, 1e-9);
}

TEST(ProgramTimes, ArcsRapidsDwellsAndWhatIsNotStated)
{
    Move arc = moveTo(MoveKind::Arc, 20, -10, 2);
    arc.centre_x_mm = 20;
    arc.centre_z_mm = 0;
    arc.feed_mm_min = 100;
    Move dwell;
    dwell.kind = MoveKind::Dwell;
    dwell.dwell_s = 1.5;
    dwell.tool = 1;
    const std::vector<Move> moves{moveTo(MoveKind::Rapid, 10, 0, 1), arc, dwell, moveTo(MoveKind::Rapid, 120, 50, 3),
                                  moveTo(MoveKind::Feed, 120, 40, 4)};
    const gcode::ToolTime all = gcode::timesOf(moves, {10, 20}).all;
    const double length = 10 * std::numbers::pi * 1.5;  // three quarters, anticlockwise
    EXPECT_NEAR(all.feed_length_mm, length + 10, 1e-9);
    EXPECT_NEAR(all.feed_time_s, 60 * length / 100, 1e-9);
    EXPECT_NEAR(all.rapid_time_s, 60 * 100. / 10000, 1e-9);
    EXPECT_EQ(all.dwell_time_s, 1.5);
    EXPECT_EQ(all.moves_without_time, 1);
}

TEST(DrawnPath, KnowsItsBlocks)
{
    gcode::Program program = gcode::readProgram(twoPasses);
    const gcode::Toolpath path = gcode::findToolpath(program);
    const DrawnPath drawn(path.moves, 0, program.blocks.size());
    ASSERT_EQ(drawn.piecesOf(9).size(), 1U);
    EXPECT_TRUE(drawn.piecesOf(1).empty());
    EXPECT_TRUE(drawn.piecesOf(-3).empty());
    EXPECT_TRUE(drawn.piecesOf(1000).empty());
    EXPECT_FALSE(drawn.isPiece(drawn.piecesOf(7).front()));  // start unknown
    EXPECT_EQ(drawn.corner(drawn.piecesOf(9).front()), (Corner{50, 15}));
    EXPECT_EQ(drawn.lineOf(drawn.nearest({30, 15.2}, 0.1, 0.1)), 9);
    EXPECT_EQ(drawn.lineOf(drawn.nearest({10, 14.1}, 0.1, 0.1)), 13);
    EXPECT_EQ(DrawnPath().nearest({0, 0}, 1, 1), DrawnPath::none);
}

TEST(DrawnPath, IsThinnedToWhatIsSeen)
{
    std::vector<Move> moves{moveTo(MoveKind::Rapid, 10, 0, 1)};
    for (int i = 1; i <= 200000; ++i)
        moves.push_back(moveTo(MoveKind::Feed, 10 + std::sin(i * 1e-4), -0.001 * i, i + 1));
    const DrawnPath drawn(moves, 0, moves.size());
    const PathWindow whole = drawn.whole(1000);
    const report::Curve all = drawn.curves(whole).front();
    EXPECT_LT(all.x.size(), 15000U);  // of 200 000; the path oscillates three times
    EXPECT_EQ(all.x.back(), 200.0);   // the end is there
    // Enlarged a thousand times every corner within is drawn again.
    PathWindow part = whole;
    part.z_mm = {100, 100.2};
    part.pixel_z_mm = 0.0002;
    part.pixel_x_mm = 0.0002;
    const report::Curve near = drawn.curves(part).front();
    EXPECT_GT(near.x.size(), 190U);
    EXPECT_LT(near.x.size(), 220U);
    // A path repeated a hundred times is drawn once.
    std::vector<Move> again;
    for (int k = 0; k < 20000; ++k)
        for (const double z : {0., -100.}) again.push_back(moveTo(MoveKind::Feed, 10, z, 1));
    const DrawnPath repeated(again, 0, 1);
    PathWindow window = repeated.whole(1000);
    window.pixel_x_mm = window.pixel_z_mm;
    EXPECT_LT(repeated.curves(window).front().x.size(), 10U);
}

TEST(ProgramCheck, AnswersWithAndWithoutStock)
{
    const ProgramCheck alone = checkProgram(twoPasses, {});
    EXPECT_FALSE(alone.stock);
    EXPECT_FALSE(answer(alone).verdict);
    EXPECT_EQ(toJson(alone)["findings"], Json());
    EXPECT_EQ(toJson(alone)["times"]["tools"].size(), 1U);
    EXPECT_FALSE(meridianPlot(alone).curves.empty());
    ASSERT_TRUE(answer(alone).value);
    EXPECT_NEAR(*answer(alone).value, alone.times.all.time_s() / 60, 1e-12);

    const ProgramCheck sound = checkProgram(twoPasses, {}, barOf(36, 100));
    ASSERT_TRUE(sound.stock);
    EXPECT_EQ(answer(sound).verdict, Verdict::Pass);
    EXPECT_EQ(passTable(sound).rows.size(), 2U);
    StockPlotParts first;
    first.pass = 0;
    EXPECT_LT(meridianPlot(sound, first).curves.size(), meridianPlot(sound).curves.size());

    std::string crash = twoPasses;
    crash.replace(crash.find("G1 Z-50."), 8, "G0 Z-50.");
    const ProgramCheck bad = checkProgram(crash, {}, barOf(36, 100));
    EXPECT_EQ(answer(bad).verdict, Verdict::Fail);
    ASSERT_FALSE(answer(bad).findings.empty());
    EXPECT_EQ(answer(bad).findings.front().place.line, std::optional<std::int64_t>(9));
    EXPECT_EQ(remarksOf(bad).front().line, 9);
}

TEST(ProgramCheck, ErrorsAreAnAnswer)
{
    const ProgramCheck check = checkProgram("%\nO1\nG21 G99\nG0 X4$0.\nM30\n%\n", {}, barOf(36, 100));
    EXPECT_FALSE(check.stock);
    const report::Answer shown_answer = answer(check);
    EXPECT_EQ(shown_answer.verdict, Verdict::Fail);
    EXPECT_FALSE(shown_answer.value);
    ASSERT_FALSE(shown_answer.findings.empty());
    EXPECT_EQ(shown_answer.findings.front().place.line, std::optional<std::int64_t>(4));
    EXPECT_FALSE(programReport(check, check.notes).sections.empty());
}

TEST(ProgramCheck, TimeThatIsNotKnownIsSaid)
{
    const ProgramCheck check = checkProgram("%\nO1\nG21 G99\nG0 X40. Z2.\nG1 Z-10. F0.2\nM30\n%\n", {});
    EXPECT_EQ(check.times.all.moves_without_time, 1);
    EXPECT_TRUE(contains(check.notes, notes::programTimeIncomplete));
}

}  // namespace lathelier::stock
