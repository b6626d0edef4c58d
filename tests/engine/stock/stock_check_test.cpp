// Stock removal by a program: closed forms, located findings, absence of false findings, limits, properties.
#include "engine/stock/stock_check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "engine/core/units.h"
#include "engine/stock/stock_codes.h"
#include "engine/stock/stock_plots.h"
#include "engine/stock/stock_quantities.h"
#include "made_program.h"

namespace lathelier::stock {
namespace {

using std::numbers::pi;

StockResult run(const Shaft& stock, const std::string& blocks, const StockParameters& parameters)
{
    return simulateStock(stock, movesOf(blocks), parameters);
}

const Note* noteOf(const StockResult& result, const NoteCode& code)
{
    for (const Note& note : result.notes)
        if (note.code == code) return &note;
    return nullptr;
}

constexpr const char* onePass = "G0 X44. Z3.\nX36.\nG1 Z-30. F0.2\nX44.\nG0 Z3.\n";

TEST(StockCheck, ACylinderIsTurned)
{
    const StockResult result = run(bar(60, 40), onePass, with(insertC()));
    ASSERT_EQ(result.passes.size(), 1U);
    // The corner leaves a fillet at the shoulder: 0.1373 mm² at radius 18.18.
    const double fillet_mm3 = 2 * pi * 18.179 * 0.64 * (1 - pi / 4);
    EXPECT_NEAR(result.passes[0].removed_mm3, pi * (400 - 324) * 30 - fillet_mm3, 1);
    EXPECT_EQ(result.passes[0].line, firstLine + 2);
    EXPECT_NEAR(*result.left.outerRadius_mm(10), 18, 1e-12);
    EXPECT_NEAR(*result.left.outerRadius_mm(31), 20, 1e-12);
    EXPECT_TRUE(result.findings.empty());
    EXPECT_NEAR(result.volume_before_mm3 - result.removed_mm3, result.left.volume_mm3(), 1e-6);
}

TEST(StockCheck, ABladeCutsAGrooveExactly)
{
    const StockResult result = run(bar(50, 40), "G0 X44. Z-10.\nG1 X30. F0.1\nX44.\n", with(blade(3)));
    EXPECT_NEAR(result.removed_mm3, pi * (400 - 225) * 3, 1e-6);
    EXPECT_NEAR(*result.left.outerRadius_mm(8.5), 15, 1e-12);
    EXPECT_NEAR(*result.left.outerRadius_mm(10.01), 20, 1e-12);
    EXPECT_NEAR(*result.left.outerRadius_mm(6.99), 20, 1e-12);
}

TEST(StockCheck, ATaperIsTurned)
{
    const StockResult result = run(bar(50, 40), "G0 X44. Z3.\nX28.5\nG1 X40. Z-20. F0.2\nG0 X44.\n", with(insertC(0)));
    EXPECT_NEAR(result.removed_mm3, pi * 400 * 20 - pi / 3 * 20 * (225 + 300 + 400), 0.05);
}

TEST(StockCheck, AShoulderAt95DegreesOverhangs)
{
    const StockResult result =
        run(bar(60, 40), "G0 X44. Z3.\nX36.\nG1 Z-30. F0.2\nX37. Z-29.5\nG0 Z3.\n", with(insertC()));
    const auto column = static_cast<std::size_t>(29.95 / result.step_mm);
    const double z = result.left.middle_mm(column);
    const std::vector<RadialSpan> spans = result.left.spans(column);
    ASSERT_EQ(spans.size(), 2U);
    const double along = z - 29.2;
    EXPECT_NEAR(spans[0].high_mm, 18.8 - std::sqrt(0.64 - along * along), 0.01);
    const double touch = 5 * pi / 180;  // where edge and corner meet, from the direction of the feed
    EXPECT_NEAR(spans[1].low_mm, 18.8 + 0.8 * std::sin(touch) + (29.2 + 0.8 * std::cos(touch) - z) / std::tan(touch),
                0.03);
    EXPECT_EQ(spans[1].high_mm, 20);
    EXPECT_TRUE(result.findings.empty());
}

TEST(StockCheck, ARapidMoveThroughStockIsLocatedOnce)
{
    const StockResult result =
        run(bar(100, 40), "G0 X44. Z3.\nG0 Z-3.\nX36.768\nG1 Z-60. F0.25\nX37.768 Z-59.5\nG0 Z3.\n", with(insertC()));
    ASSERT_EQ(result.findings.size(), 1U);
    const StockFinding& finding = result.findings.front();
    EXPECT_EQ(finding.line, firstLine + 2);
    EXPECT_EQ(finding.kind, FindingKind::RapidThroughStock);
    EXPECT_EQ(finding.path, MovePath::Both);
    EXPECT_NEAR(finding.depth_mm, 1.616, 1e-3);
    EXPECT_NEAR(finding.z_mm, 2.2, 0.02);
    EXPECT_NEAR(finding.x_mm, 18.384, 1e-3);
    EXPECT_GT(result.removed_by_findings_mm3, 0);
    EXPECT_NEAR(result.volume_before_mm3 - result.removed_mm3 - result.removed_by_findings_mm3,
                result.left.volume_mm3(), 1e-6);
}

TEST(StockCheck, TouchingIsNoFindingButASmallClearance)
{
    const StockResult result =
        run(bar(60, 40), "G0 X44. Z3.\nX36.\nG1 Z-30. F0.2\nX37. Z-29.5\nG0 Z3.\nX36.\nZ-29.\n", with(insertC()));
    EXPECT_TRUE(result.findings.empty());
    const Note* note = noteOf(result, notes::smallClearance);
    ASSERT_NE(note, nullptr);
    EXPECT_EQ(std::get<std::int64_t>(*find(note->values, "line")), firstLine + 6);
}

TEST(StockCheck, TheDogLegFindsWhatTheStraightPathMisses)
{
    const std::string blocks = "G0 X60. Z-30.\nX60.\nG0 X20. Z40.\n";
    StockParameters parameters = with(insertC());
    parameters.z_zero_mm = 0;
    // From z = 30, x = 30 to z = -40, x = 10: straight it passes the front face at x = 21.4, at equal rates at 10.
    const StockResult result = run(bar(100, 40), blocks, parameters);
    ASSERT_EQ(result.findings.size(), 1U);
    EXPECT_EQ(result.findings[0].path, MovePath::DogLeg);
    EXPECT_EQ(result.findings[0].line, firstLine + 2);
    EXPECT_NEAR(result.findings[0].depth_mm, 10, 0.01);
    parameters.dog_leg = false;
    EXPECT_TRUE(run(bar(100, 40), blocks, parameters).findings.empty());
    parameters.dog_leg = true;
    parameters.rapid_x_m_min = 20 * 2.0 / 7;  // as if both axes arrived together
    EXPECT_TRUE(run(bar(100, 40), blocks, parameters).findings.empty());
}

TEST(StockCheck, TheHolderTrailsTheCut)
{
    Tool tool = insertC();
    tool.holder = {{-20, 1}, {-3, 1}, {-3, 40}, {-20, 40}};
    EXPECT_TRUE(run(bar(60, 40), onePass, with(tool)).findings.empty());
}

TEST(StockCheck, AHolderThatMeetsStockIsFoundAfterTheCut)
{
    Tool tool = blade(3, 10);
    tool.holder = {{-20, 4}, {-1, 4}, {-1, 40}, {-20, 40}};
    const StockResult result = run(bar(100, 40), "G0 X60. Z-50.\nG1 X33. F0.1\nX28.\nX60.\n", with(tool));
    ASSERT_EQ(result.findings.size(), 1U);
    const StockFinding& finding = result.findings.front();
    EXPECT_EQ(finding.kind, FindingKind::HolderInStock);
    EXPECT_EQ(finding.line, firstLine + 2);
    EXPECT_NEAR(finding.depth_mm, 2, 1e-6);
    EXPECT_NEAR(finding.x_mm, 18, 1e-6);
    EXPECT_NEAR(finding.width_mm, 17, 0.05);
}

TEST(StockCheck, TheChuckIsFoundAndItsFaceMayBeTouched)
{
    StockParameters parameters = with(insertC());
    parameters.chuck = ChuckBody{80, 60};
    const auto to = [&](const std::string& z) {
        return run(bar(100, 40), "G0 X44. Z3.\nX36.\nG1 Z" + z + " F0.2\nX37. W0.5\nG0 X44.\nZ3.\n", parameters);
    };
    EXPECT_TRUE(to("-80.").findings.empty());
    const StockResult result = to("-80.5");
    ASSERT_FALSE(result.findings.empty());
    EXPECT_EQ(result.findings[0].kind, FindingKind::Chuck);
    EXPECT_EQ(result.findings[0].line, firstLine + 2);
    EXPECT_NEAR(result.findings[0].depth_mm, 0.5, 1e-3);
    EXPECT_NEAR(result.findings[0].z_mm, 80.5, 1e-3);
    parameters.chuck = ChuckBody{{}, 0};
    EXPECT_TRUE(to("-99.").findings.empty());
    EXPECT_FALSE(to("-101.").findings.empty());
}

TEST(StockCheck, TheTailstockIsFound)
{
    StockParameters parameters = with(insertC());
    const std::string blocks = "G0 X80. Z3.\nX10.\nX80.\n";
    EXPECT_TRUE(run(bar(100, 40), blocks, parameters).findings.empty());
    parameters.tailstock = TailstockBody{};
    const StockResult result = run(bar(100, 40), blocks, parameters);
    ASSERT_FALSE(result.findings.empty());
    EXPECT_EQ(result.findings[0].kind, FindingKind::Tailstock);
    EXPECT_LT(result.findings[0].z_mm, -3);
    EXPECT_EQ(result.findings[0].line, firstLine + 1);
}

TEST(StockCheck, AMoveFromAReferencePointHasNoPath)
{
    const StockResult result =
        run(bar(60, 40), std::string("G28 U0. W0.\n") + onePass + "G28 U0. W0.\nG0 X50. Z3.\n", with(insertC()));
    EXPECT_TRUE(result.findings.empty());
    const Note* note = noteOf(result, notes::startUnknown);
    ASSERT_NE(note, nullptr);
    EXPECT_EQ(std::get<std::int64_t>(*find(note->values, "count")), 2);
    // Only its end is checked.
    const StockResult inside = run(bar(60, 40), "G28 U0. W0.\nG0 X30. Z-20.\n", with(insertC()));
    ASSERT_EQ(inside.findings.size(), 1U);
    EXPECT_EQ(inside.findings[0].path, MovePath::Programmed);
}

TEST(StockCheck, AirCutsThreadsAndDrillingAreNoted)
{
    const StockResult air = run(bar(60, 40), "G0 X44. Z3.\nX42.\nG1 Z-30. F0.2\nX44.\n", with(insertC()));
    const Note* note = noteOf(air, notes::aboveStockFeed);
    ASSERT_NE(note, nullptr);
    EXPECT_EQ(std::get<std::int64_t>(*find(note->values, "line")), firstLine + 2);
    EXPECT_TRUE(air.findings.empty());
    EXPECT_EQ(noteOf(run(bar(60, 40), onePass, with(insertC())), notes::aboveStockFeed), nullptr);

    Tool threading = insertC(0.1);
    threading.tip_angle_deg = 60;
    threading.tip = 8;
    threading.kind = ToolKind::ThreadingInsert;
    const StockResult thread = run(bar(60, 40), "G0 X44. Z3.\nX38.\nG32 Z-20. F1.5\nG0 X44.\nZ3.\n", with(threading));
    EXPECT_NE(noteOf(thread, notes::threadAsRoot), nullptr);
    EXPECT_TRUE(thread.findings.empty());
    EXPECT_NEAR(*thread.left.outerRadius_mm(10), 19, 1e-9);

    const std::string drilling = "T0101\nG0 X0. Z3.\nG1 Z-20. F0.1\nG0 Z3.\n";
    const StockResult unknown = run(bar(60, 40), drilling, {});
    EXPECT_NE(noteOf(unknown, notes::drillingNotModelled), nullptr);
    EXPECT_NE(noteOf(unknown, notes::toolAssumed), nullptr);
    EXPECT_TRUE(unknown.passes.empty());
    Tool drill;
    drill.kind = ToolKind::Drill;
    drill.diameter_mm = 10;
    drill.tip_angle_deg = 118;
    drill.reach_mm = 60;
    const StockResult drilled = run(bar(60, 40), drilling, with(drill));
    EXPECT_TRUE(drilled.findings.empty());
    const double cone_mm = 5 / std::tan(59 * pi / 180);
    EXPECT_NEAR(drilled.removed_mm3, pi * 25 * (20 - cone_mm) + pi * 25 * cone_mm / 3, 0.05);
    EXPECT_NEAR(*drilled.left.innerRadius_mm(5), 5, 1e-9);
}

TEST(StockCheck, ABoredTubeIsTurnedFromInside)
{
    Tool boring = insertC(0.4);
    boring.tip = 2;
    boring.kind = ToolKind::BoringBar;
    boring.edge_length_mm = 6;
    const StockResult result =
        run(bar(60, 40, 20), "G0 X18. Z3.\nX24.\nG1 Z-30. F0.1\nX22. Z-29.\nG0 Z3.\n", with(boring));
    EXPECT_TRUE(result.findings.empty());
    EXPECT_NEAR(*result.left.innerRadius_mm(10), 12, 1e-9);
    EXPECT_NEAR(*result.left.outerRadius_mm(10), 20, 1e-9);
}

TEST(StockCheck, GroovesInAnyOrderLeaveTheSame)
{
    const std::string a = "G0 X44. Z-10.\nG1 X30. F0.1\nG0 X44.\n", b = "G0 X44. Z-20.\nG1 X25. F0.1\nG0 X44.\n";
    const StockResult one = run(bar(50, 40), a + b, with(blade(3))), other = run(bar(50, 40), b + a, with(blade(3)));
    ASSERT_EQ(one.passes.size(), 2U);
    EXPECT_NEAR(one.passes[0].removed_mm3, other.passes[1].removed_mm3, 1e-9);
    EXPECT_EQ(one.passes.back().after, other.passes.back().after);
    EXPECT_TRUE(one.findings.empty());
}

TEST(StockCheck, DimensionScaling)
{
    const auto scaled = [](double k) {
        Tool tool = insertC(0.8 * k);
        tool.edge_length_mm = 12 * k;
        StockParameters parameters = with(tool);
        parameters.step_mm *= k;
        parameters.feed_step_mm *= k;
        parameters.touch_mm *= k;
        std::vector<gcode::Move> moves =
            movesOf("G0 X44. Z3.\nX36.\nG1 Z-30. F0.2\nG2 X40. Z-32. R2.\nG0 Z-20.\nX30.\n");
        for (gcode::Move& move : moves)
            for (double* value : {&move.x_mm, &move.z_mm, &move.centre_x_mm, &move.centre_z_mm}) *value *= k;
        return simulateStock(bar(60 * k, 40 * k), moves, parameters);
    };
    const double k = 2.5;
    const StockResult one = scaled(1), other = scaled(k);
    EXPECT_NEAR(other.removed_mm3 / one.removed_mm3, k * k * k, 2e-3 * k * k * k);
    ASSERT_EQ(one.findings.size(), 1U);
    ASSERT_EQ(other.findings.size(), 1U);
    EXPECT_NEAR(other.findings[0].depth_mm, k * one.findings[0].depth_mm, 0.01);
    EXPECT_NEAR(other.findings[0].z_mm, k * one.findings[0].z_mm, 0.06);
}

TEST(StockCheck, WorkIsBoundedAndStops)
{
    const StockResult longBar = run(bar(3000, 40), onePass, with(insertC()));
    EXPECT_NEAR(longBar.step_mm, 0.15, 1e-9);
    EXPECT_NE(noteOf(longBar, notes::stockStepWidened), nullptr);
    EXPECT_TRUE(longBar.findings.empty());

    std::stop_source source;
    std::vector<gcode::Move> moves;
    for (int i = 0; i < 2000; ++i) {
        gcode::Move move;
        move.line = i + 1;
        move.kind = i % 2 == 0 ? gcode::MoveKind::Rapid : gcode::MoveKind::Feed;
        move.x_mm = 19 - i * 0.005;
        move.z_mm = i % 2 == 0 ? 3 : -280;
        moves.push_back(move);
    }
    double last = -1;
    const Progress progress(source.get_token(), [&](double fraction, Text) {
        EXPECT_GE(fraction, last);
        last = fraction;
        if (fraction > 0.2) source.request_stop();
    });
    EXPECT_THROW(simulateStock(bar(287.5, 40), moves, with(insertC()), progress), Cancelled);
    EXPECT_LT(last, 0.5);
}

RC_GTEST_PROP(StockCheckProperty, NoMovesAreTooWild, (unsigned seed))
{
    std::mt19937 random(seed);
    const auto pick = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto place = [&](double scale) {
        const double wild[] = {notANumber, 1e300, -1e300, INFINITY, 0};
        return pick(12) == 0 ? wild[pick(5)] : std::uniform_real_distribution<double>(-scale, scale)(random);
    };
    std::vector<gcode::Move> moves;
    for (int i = 0; i < 40; ++i) {
        gcode::Move move;
        move.line = i + 1;
        move.kind = static_cast<gcode::MoveKind>(pick(5));
        move.clockwise = pick(2) == 0;
        move.x_mm = place(30);
        move.z_mm = place(60);
        move.centre_x_mm = place(100);
        move.centre_z_mm = place(100);
        move.tool = pick(4);
        moves.push_back(move);
    }
    Tool back = insertC(0.4);
    back.number = 1;
    back.tip = pick(10);
    back.shank_width_mm = 20;
    Tool groove = blade(2);
    groove.number = 2;
    groove.holder = {{-20, 4}, {-1, 4}, {-1, 40}, {-20, 40}};
    StockParameters parameters;
    parameters.tools = {back, groove};
    parameters.step_mm = 0.1;
    parameters.chuck = ChuckBody{};
    parameters.tailstock = TailstockBody{};
    const StockResult result = simulateStock(bar(50, 40, 5), moves, parameters);
    RC_ASSERT(std::abs(result.volume_before_mm3 - result.removed_mm3 - result.removed_by_findings_mm3 -
                       result.left.volume_mm3()) < 1e-5);
    for (const StockFinding& finding : result.findings) {
        RC_ASSERT(std::isfinite(finding.z_mm) && std::isfinite(finding.x_mm) && finding.depth_mm > 0);
        RC_ASSERT(finding.line > 0);
    }
}

TEST(StockCheck, ResultsAreDescribedAndDrawn)
{
    StockParameters parameters = with(insertC());
    parameters.chuck = ChuckBody{90, 0};
    const std::vector<gcode::Move> moves = movesOf("G0 X44. Z3.\nG0 Z-3.\nX36.\nG1 Z-60. F0.25\nX40.\n");
    const StockResult result = simulateStock(bar(100, 40), moves, parameters);
    const Json json = nestedJson(describedValues(result));
    ASSERT_EQ(json["findings"].size(), 1U);
    EXPECT_EQ(json["findings"][0]["kind"], "rapid_through_stock");
    EXPECT_EQ(json["findings"][0]["line"], firstLine + 2);
    ASSERT_EQ(json["stock_passes"].size(), 1U);
    EXPECT_EQ(json["stock_passes"][0]["contour"]["z_mm"].size(), json["stock_passes"][0]["contour"]["x_mm"].size());
    EXPECT_GT(json["stock_passes"][0]["removed_mm3"].get<double>(), 1000);
    const DrawnPath drawn(moves, 0, 100);
    StockPlotParts parts;
    parts.path = &drawn;
    const report::Plot plot = stockPlot(result, parts);
    EXPECT_EQ(plot.marks.size(), 1U);
    EXPECT_TRUE(plot.equal_scales);
    EXPECT_EQ(plot.regions.size(), 3U);
    EXPECT_EQ(report::axisLabel(plot.y), "Radius (mm)");
    const StockParameters again = fromValues<StockParameters>(toValues(parameters));
    EXPECT_EQ(again, parameters);
}

}  // namespace
}  // namespace lathelier::stock
