// A shaft as it is drawn, dragged, held and weighed.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/shaft/forced_shape.h"
#include "engine/receptance/shaft/shaft_plots.h"
#include "engine/receptance/shaft/shaft_report.h"
#include "made_spindle.h"

namespace lathelier::receptance {
namespace {

using io::readShaft;
using io::readStock;
using io::shaftText;
using io::stockText;

constexpr double rigidStiffness = std::numeric_limits<double>::infinity();

ReceptanceParameters coarse()
{
    ReceptanceParameters parameters;
    parameters.step_hz = 50;
    return parameters;
}

TEST(ShaftStudy, WeighsAndBendsAsACantilever)
{
    const Shaft rod = cylinder(250, 40);
    const ShaftHolding clamped{{}, {{250, rigidStiffness, rigidStiffness, 0}}};
    const ShaftStudy study = studyShaft(rod, coarse(), clamped);
    const double area_mm2 = std::numbers::pi * 400;
    EXPECT_NEAR(study.mass_kg, area_mm2 * 250 * 7850e-9, 1e-9);
    // L³/3EI + L/κGA
    const double inertia_mm4 = std::numbers::pi * 160000 / 4;
    const double shear = 210000 / 2.6 * area_mm2;
    const double kappa = 6 * 1.3 * 1.3 / (7 + 12 * 0.3 + 4 * 0.09);
    ASSERT_TRUE(study.static_mm_N);
    EXPECT_NEAR(*study.static_mm_N, std::pow(250, 3) / (3 * 210000 * inertia_mm4) + 250 / (kappa * shear), 1e-10);
    ASSERT_EQ(study.modes.size(), study.response.natural_frequencies_hz->size());
    EXPECT_NEAR(study.modes.front().frequency_hz, study.response.natural_frequencies_hz->front(), 1e-7);
    EXPECT_NEAR(study.modes.front().deflection.front(), 1, 1e-9);  // the free end
    EXPECT_NEAR(study.modes.front().deflection.back(), 0, 1e-9);   // the chuck
}

TEST(ShaftStudy, HasNoComplianceWhenFreeAndNoModesOnATable)
{
    const ShaftStudy free = studyShaft(cylinder(250, 40), coarse(), {});
    EXPECT_FALSE(free.static_mm_N);
    EXPECT_NEAR(free.modes.front().frequency_hz, 2771, 10);
    ReceptanceParameters within = coarse();
    within.to_hz = 400;
    const ShaftStudy table = studyShaft(cylinder(250, 40), within, {SpindleReceptance{livelySpindle(50, 400, 17)}, {}});
    EXPECT_FALSE(table.static_mm_N);
    EXPECT_TRUE(table.modes.empty());
    EXPECT_GT(table.mass_kg, 2);
}

TEST(ShaftStudy, ATailstockStiffens)
{
    const ShaftStudy alone = studyShaft(newPart(), coarse(), {springs(), {}});
    const ShaftStudy held = studyShaft(newPart(), coarse(), {springs(), {{0, 10000, 0, 0.05}}});
    EXPECT_LT(*held.static_mm_N, 0.6 * *alone.static_mm_N);
    EXPECT_GT(held.modes.front().frequency_hz, 1.3 * alone.modes.front().frequency_hz);
    // A spring at the free end is a compliance beside that of the shaft: 1/G + k.
    EXPECT_NEAR(1 / *held.static_mm_N, 1 / *alone.static_mm_N + 10000, 1);
}

TEST(ShaftStudy, TheSpindleAloneGivesWhatItGaveBefore)
{
    const ShaftReceptanceResult before = shaftReceptance(newPart(), coarse(), springs());
    const ShaftReceptanceResult now = heldShaftReceptance(newPart(), coarse(), {springs(), {}});
    EXPECT_EQ(before.frf.value, now.frf.value);
    EXPECT_EQ(before.natural_frequencies_hz, now.natural_frequencies_hz);
}

TEST(ShaftDrawing, ShowsContourDimensionsAndHandles)
{
    const report::Plot plot = shaftDrawing(newPart(), {springs(), {}}, true);
    EXPECT_TRUE(plot.equal_scales);
    ASSERT_EQ(plot.handles.size(), 4U);
    EXPECT_DOUBLE_EQ(plot.handles[1].x, 108);
    EXPECT_DOUBLE_EQ(plot.handles[1].y, 18.5);
    EXPECT_EQ(plot.marks.size(), 8U);  // a diameter and a length each
    EXPECT_TRUE(shaftDrawing(newPart(), {}, false).handles.empty());
    const double with = static_cast<double>(plot.regions.size());
    EXPECT_GT(with, shaftDrawing(newPart(), {}, false).regions.size());  // the chuck
    Shaft long_one = newPart();
    for (int i = 0; i < 20; ++i) long_one.segments.push_back(long_one.segments.front());
    EXPECT_TRUE(shaftDrawing(long_one, {}, true).handles.empty());
    EXPECT_TRUE(shaftDrawing({}, {}, true).curves.empty());
}

TEST(ShaftDrawing, AnEndIsDragged)
{
    const Shaft before = newPart();
    ASSERT_EQ(segmentOfHandle(shaftDrawing(before, {}, true).handles[1].key), 1U);
    EXPECT_FALSE(segmentOfHandle("operating_point"));
    const Shaft after = dragged(before, 1, 112.04, 20.02);
    EXPECT_DOUBLE_EQ(after.segments[1].length_mm, 14);
    EXPECT_DOUBLE_EQ(after.segments[2].length_mm, 71);
    EXPECT_DOUBLE_EQ(after.segments[1].start_diameter_mm, 40);  // a cylinder stays one
    EXPECT_DOUBLE_EQ(after.segments[1].end_diameter_mm, 40);
    EXPECT_NEAR(after.length_mm(), before.length_mm(), 1e-9);
    EXPECT_EQ(after.segments[0], before.segments[0]);
    EXPECT_NEAR(dragged(before, 1, 500, 18.5).segments[2].length_mm, 0.1, 1e-9);
    EXPECT_DOUBLE_EQ(dragged(before, 1, -5, 18.5).segments[1].length_mm, 0.1);
    EXPECT_DOUBLE_EQ(dragged(before, 3, 250, 20).length_mm(), 250);  // the last one grows by itself
    EXPECT_EQ(dragged(before, 7, 1, 1), before);
    Shaft bored = before;
    bored.segments[0].bore_diameter_mm = 20;
    bored.segments[0].end_diameter_mm = 36;
    const Shaft thin = dragged(bored, 0, 98, 3);
    EXPECT_DOUBLE_EQ(thin.segments[0].end_diameter_mm, 20.2);
    EXPECT_DOUBLE_EQ(thin.segments[0].start_diameter_mm, 30);  // a cone's other end stays
}

TEST(ShaftDrawing, ShapesSwing)
{
    const ShaftStudy study = studyShaft(newPart(), coarse(), {springs(), {}});
    const report::Plot still = modeShapesPlot(study);
    const report::Plot half = modeShapesPlot(study, -0.5);
    ASSERT_EQ(still.curves.size(), study.modes.size());
    EXPECT_DOUBLE_EQ(half.curves[0].y[0], -0.5 * still.curves[0].y[0]);
}

TEST(ShaftReport, SaysMassAndCompliance)
{
    const ShaftHolding holding{springs(), {}};
    const ShaftStudy study = studyShaft(newPart(), coarse(), holding);
    const report::Answer studyAnswer = answer(study);
    EXPECT_NEAR(*studyAnswer.value, study.modes.front().frequency_hz, 1e-7);
    ASSERT_EQ(studyAnswer.findings.size(), 2U);
    EXPECT_NE(report::findingText(studyAnswer.findings[0]).find("nm/N"), std::string::npos);
    EXPECT_NE(report::findingText(studyAnswer.findings[1]).find("200.0"), std::string::npos);
    const report::Document document = shaftReport(study, newPart(), holding);
    ASSERT_GE(document.sections.size(), 4U);
    EXPECT_EQ(document.sections[1].blocks.size(), 3U);
}

TEST(ShaftFile, WritesWhatItReads)
{
    Shaft shaft = newPart();
    shaft.name = "part";
    shaft.segments[0].bore_diameter_mm = 7.3;
    shaft.segments[2].arc_radius_mm = -500;
    shaft.segments[2].role = "groove";
    Notes notes;
    EXPECT_EQ(readShaft(shaftText(shaft), notes), shaft);
    EXPECT_TRUE(notes.empty());
    const Shaft stock = readStock(stockText(shaft));
    EXPECT_EQ(stock.segments.size(), 3U + 50U);
    EXPECT_NEAR(stock.length_mm(), shaft.length_mm(), 1e-9);
    EXPECT_EQ(stock.segments[0].bore_diameter_mm, 7.3);
    EXPECT_LT(stock.segments[27].end_diameter_mm, 33.8);  // the groove
}

TEST(ForcedShape, IsTheResponseOfEachPlaceToTheForce)
{
    const Shaft rod = cylinder(250, 40);
    const ShaftHolding on_springs{SpindleReceptance{SpindleSprings{2e5, 1e9, 0.02}}, {}};
    ReceptanceParameters parameters;
    parameters.excite_z_mm = 40;
    parameters.from_hz = parameters.to_hz = 700;
    const ForcedShape shape = forcedShape(rod, parameters, on_springs, 700);
    EXPECT_EQ(shape.force_z_mm, 40);
    EXPECT_EQ(shape.z_mm.front(), 0);
    EXPECT_EQ(shape.z_mm.back(), 250);
    for (const std::size_t place : {std::size_t{0}, shape.z_mm.size() / 2, shape.z_mm.size() - 1}) {
        parameters.respond_z_mm = shape.z_mm[place];
        const Complex expected =
            receptanceOf(rod, rod.material.value_or(Material{}), parameters, on_springs).value.front();
        EXPECT_NEAR(std::abs(shape.deflection_mm_N[place] - expected), 0, 1e-9 * std::abs(expected));
    }
}

TEST(ForcedShape, SwingsAsAClosedSurfaceOneMillimetreWide)
{
    Shaft stepped = cylinder(120, 30);
    stepped.segments.push_back({80, 50, 50, 0, {}, {}});
    const ShaftHolding clamped{{}, {{200, rigidStiffness, rigidStiffness, 0}}};
    const ForcedShape shape = forcedShape(stepped, coarse(), clamped, 400);
    const Skin skin = swingingSkin(stepped, shape, 0);
    EXPECT_EQ(skin.values.size(), skin.vertexCount());
    EXPECT_EQ(skin.shift_mm.size(), skin.vertexCount());
    EXPECT_EQ(skin.stations.front().radius_mm, 0);
    EXPECT_EQ(skin.stations.back().radius_mm, 0);
    EXPECT_NEAR(skin.shift_mm.front().x(), 1, 1e-6);  // at the free end, below the second mode
    EXPECT_NEAR(skin.values.front(), 1000 * shape.largestDeflection(), 1e-3 * shape.largestDeflection() * 1000);
    EXPECT_NEAR(skin.shift_mm.back().x(), 0, 1e-6);  // at the rigid chuck
    const Skin later = swingingSkin(stepped, shape, std::numbers::pi);
    EXPECT_NEAR(later.shift_mm.front().x(), -1, 1e-6);
    EXPECT_EQ(later.values, skin.values);
}

}  // namespace
}  // namespace lathelier::receptance
