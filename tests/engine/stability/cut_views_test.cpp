// Views of a simulated cut: phase and marks against worked numbers, waves, surface, amplitude, spectrum, explanation.
#include "engine/stability/simulation/cut_views.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/report/plot_svg.h"
#include "engine/stability/lobes.h"
#include "engine/stability/simulation/growth_chart.h"
#include "engine/stability/simulation/why.h"
#include "tests/engine/stability/machines.h"

namespace lathelier::stability {
namespace {

SimulationResult simulatedCutAt(double speed_rpm, double depth_mm, int revolutions = 60)
{
    SimulationParameters p;
    p.speed_rpm = speed_rpm;
    p.depth_mm = depth_mm;
    p.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    p.revolutions = revolutions;
    return simulate(paperA, p);
}

TEST(CutViews, MarksOfChatterAsWorkedByHand)
{
    const WavePhase phase = phaseOf(361, 2016, 0.1);  // 10.744 waves: 11 - 0.256
    EXPECT_EQ(phase.whole, 10);
    EXPECT_NEAR(phase.phase_deg, 267.9, 0.05);
    EXPECT_NEAR(phase.fraction, -0.256, 5e-4);
    EXPECT_NEAR(phase.period_mm, 0.391, 5e-4);
    EXPECT_TRUE(std::isinf(phaseOf(100, 2000, 0.1).period_mm)) << "three whole waves: the marks run along the axis";
}

TEST(CutViews, TheLastRevolutionIsThatOfTheResultAndTheOuterWaveTheInnerOneBefore)
{
    for (const double depth_mm : {0.2, 0.6}) {  // with contact, and with loss of it
        const SimulationResult cut = simulatedCutAt(2885, depth_mm);
        EXPECT_EQ(revolutionsOf(cut), 60);
        const WavePair last = wavesOf(cut, 59);
        EXPECT_EQ(last.inner_mm, cut.waves.inner_mm);
        ASSERT_EQ(last.outer_mm.size(), cut.waves.outer_mm.size());
        for (std::size_t i = 0; i < last.outer_mm.size(); ++i)
            EXPECT_NEAR(last.outer_mm[i], cut.waves.outer_mm[i], 1e-12);
        EXPECT_EQ(wavesOf(cut, 1000).inner_mm, last.inner_mm) << "beyond the end: the last one";
        const WavePair first = wavesOf(cut, 0), second = wavesOf(cut, 1);
        for (std::size_t i = 0; i < first.outer_mm.size(); ++i) {
            EXPECT_EQ(first.outer_mm[i], 0);
            if (cut.chip_mm[i] > 0) {
                EXPECT_EQ(second.outer_mm[i], first.inner_mm[i]);
            }
        }
    }
}

TEST(CutViews, TheSurfaceHoldsARowForEachRevolution)
{
    const SimulationResult cut = simulatedCutAt(2885, 0.6);
    const report::ColourMap map = surfaceMap(cut, 59, 40);
    EXPECT_EQ(map.rows, 40);
    EXPECT_NEAR(map.y_from, 2.0, 1e-12);
    EXPECT_NEAR(map.y_to, 6.0, 1e-12);
    EXPECT_EQ(map.values.size(), static_cast<std::size_t>(map.rows) * static_cast<std::size_t>(map.columns));
    EXPECT_GT(map.limit, 10) << "chatter marks, µm";
    EXPECT_EQ(surfaceMap(cut, 4, 40).rows, 5);
    EXPECT_LT(surfaceMap(simulatedCutAt(2885, 0.15, 120), 119, 10).limit, 0.01) << "a stable cut leaves none";
}

TEST(CutViews, TheAmplitudeFollowsTheGrowthUntilTheToolLeavesTheCut)
{
    const SimulationResult cut = simulatedCutAt(2885, 0.36);
    const report::Plot plot = amplitudePlot(cut);
    ASSERT_EQ(plot.curves.size(), 2U);
    EXPECT_NEAR(plot.curves[0].y[20] / plot.curves[0].y[10], std::pow(cut.growth_per_revolution, 10), 0.03);
    EXPECT_NEAR(plot.curves[1].y[10] / plot.curves[1].y[9], cut.growth_per_revolution, 1e-9);
}

TEST(CutViews, TheSpectrumStandsAtTheFrequencyOfTheVibration)
{
    const SimulationResult cut = simulatedCutAt(2885, 0.33, 100);
    const report::Plot plot = spectrumPlot(cut, 1000);
    const auto& curve = plot.curves.front();
    const auto top = static_cast<std::size_t>(std::max_element(curve.y.begin(), curve.y.end()) - curve.y.begin());
    EXPECT_NEAR(curve.x[top], cut.frequency_hz, 1.0);
    EXPECT_LE(curve.x.back(), 1000);
}

TEST(GrowthChart, LiesOverTheMapOnScreenAndOnPaper)
{
    LobeParameters asked;
    asked.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    asked.speed_rpm = {{2000, 4000}};
    const LobeResult exact = findLobes(frfOf(paperA, 4000), asked);
    RasterParameters grid;
    grid.speed_rpm = {2000, 4000};
    grid.columns = grid.rows = 12;
    const RasterResult raster = stabilityRaster(paperA, grid);
    const report::Plot with = growthChart(exact, &raster, {2800, 0.2}),
                       without = growthChart(exact, nullptr, {2800, 0.2});
    ASSERT_TRUE(with.ground.has_value());
    EXPECT_TRUE(with.regions.empty());
    EXPECT_FALSE(without.ground.has_value());
    EXPECT_EQ(without.regions.size(), 2U);
    EXPECT_NE(toSvg(with).find("<image"), std::string::npos);
    EXPECT_EQ(toSvg(without).find("<image"), std::string::npos);
    asked.relation = SpeedRelation::Published;
    const report::Plot both = comparisonChart(exact, findLobes(frfOf(paperA, 4000), asked), &raster, {2800, 0.2});
    EXPECT_EQ(both.curves.size(), 2U);
}

TEST(Why, StatesTheNumbersOfThisCut)
{
    LobeParameters asked;
    asked.cutting_coefficient_N_mm2 = coefficient_N_mm2;
    asked.speed_rpm = {{2000, 4000}};
    const Frf frf = frfOf(paperA, 4000);
    const LobeResult lobes = findLobes(frf, asked);
    const std::vector<WhyLine> lines = whyOf(simulatedCutAt(2885, 0.2), lobes, frf);
    ASSERT_EQ(lines.size(), 8U);
    EXPECT_EQ(lines[0].numbers, "60 / 2885 = 20.80 ms");
    EXPECT_EQ(lines[1].numbers, "2000 · 0.200 · 0.100 = 40.0 N");
    EXPECT_NE(lines[5].numbers.find("= 0.310 mm"), std::string::npos) << lines[5].numbers;
    EXPECT_NE(lines[6].numbers.find("= 2885"), std::string::npos) << lines[6].numbers;
}

}  // namespace
}  // namespace lathelier::stability
