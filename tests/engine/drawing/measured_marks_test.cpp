// Drawings of marks that a scan measured: U of their places, depths and angles, ends at shoulders, what lies behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/drawing/features.h"
#include "engine/drawing/marks/mark_geometry.h"
#include "engine/drawing/marks/section_drawing.h"
#include "engine/drawing/rows.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/drawing/view.h"
#include "placement.h"

namespace lathelier::drawing {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

/// ⌀25 × 40, ⌀35 × 60, ⌀30 × 31 as a scan measured it, with 6 µm along z and 2 µm of a ⌀.
Shaft measuredShaft(std::vector<ShaftMark> marks)
{
    Shaft shaft;
    shaft.name = "part";
    shaft.recovered.scan = "part.ply";
    for (const auto& [length_mm, diameter_mm] : {std::pair(40.0, 25.0), {60.0, 35.0}, {31.0, 30.0}}) {
        ShaftSegment row{length_mm, diameter_mm, diameter_mm, 0, {}, ""};
        row.measured = MeasuredSize{length_mm, diameter_mm, diameter_mm, {}, {}};
        row.measured->uncertainty.z_start_um = row.measured->uncertainty.z_end_um = 6;
        row.measured->uncertainty.start_diameter_um = row.measured->uncertainty.end_diameter_um = 2;
        shaft.segments.push_back(row);
    }
    shaft.marks = std::move(marks);
    return shaft;
}

ShaftMark measured(MarkKind kind, double from_mm, double to_mm, double angle_deg)
{
    ShaftMark mark{kind};
    mark.z_start_mm = from_mm;
    mark.z_end_mm = to_mm;
    mark.angle_deg = angle_deg;
    mark.uncertainty_mm = 0.18;
    mark.place_uncertainty_mm = 0.13;
    mark.depth_uncertainty_mm = 0.006;
    mark.angle_uncertainty_deg = 0.2;
    return mark;
}

ShaftMark measuredKeyway(double from_mm, double to_mm, double angle_deg)
{
    ShaftMark mark = measured(MarkKind::Keyway, from_mm, to_mm, angle_deg);
    mark.width_mm = 8;
    mark.floor_mm = 8.5;
    mark.designation = "DIN 6885 - A 8×7×28";
    return mark;
}

ShaftMark measuredFlat(double from_mm, double to_mm, double angle_deg, double distance_mm)
{
    ShaftMark mark = measured(MarkKind::Flat, from_mm, to_mm, angle_deg);
    mark.uncertainty_mm = 0.006;
    mark.distance_mm = distance_mm;
    return mark;
}

std::multiset<std::string> textsOf(const Drawing& drawing)
{
    std::multiset<std::string> all;
    for (const Label& label : drawing.labels) all.insert(label.text);
    return all;
}

std::multiset<std::string> textsOf(const Shaft& shaft)
{
    return textsOf(drawShaft(shaft, {}));
}

TEST(MeasuredMarks, PlacesDepthsAndAnglesHaveTheirU)
{
    ShaftMark second = measuredKeyway(104, 126, 110);
    second.floor_mm = 11;
    const std::multiset<std::string> all = textsOf(measuredShaft({measuredKeyway(6, 34, 20), second}));
    // 0.13 and 6 µm of the free end; 0.13·√2; 0.006 and 1 µm of the radius; 0.2·√2.
    for (const char* text : {"6.00 ±0.13", "34.00 ±0.13", "8.00 ±0.18", "(length 28.00 ±0.18)", "21.000 ±0.006",
                             "26.000 ±0.006", "90.0° ±0.3°", "DIN 6885 - A 8×7×28"})
        EXPECT_THAT(all, Contains(text));
}

TEST(MeasuredMarks, TwoKeywaysOfOneSectionAreToldApartAndReadFromTheRight)
{
    // Measured angles are not quite 90°.
    for (const double angle_deg : {89.97, 90.03, -90.03, -89.97, 180.02}) {
        ShaftMark second = measuredKeyway(6, 30, angle_deg);
        const Drawing drawing = drawShaft(measuredShaft({measuredKeyway(6, 34, 0), second}), {});
        EXPECT_THAT(textsOf(drawing), Contains("(length 28.00 ±0.18)"));
        EXPECT_THAT(textsOf(drawing),
                    Contains(angle_deg > 179 ? "180°: (length 24.00 ±0.18)" : "90°: (length 24.00 ±0.18)"));
        for (const Label& label : drawing.labels) {
            EXPECT_GT(label.angle_deg, -85) << label.text;
            EXPECT_LT(label.angle_deg, 95) << label.text;
        }
        EXPECT_THAT(overlappingTexts(drawing), IsEmpty()) << angle_deg;
        EXPECT_THAT(crossedTexts(drawing), IsEmpty()) << angle_deg;
    }
}

TEST(MeasuredMarks, LegendIsSaidOnceAndTellsOfMissingU)
{
    const std::multiset<std::string> all = textsOf(measuredShaft({measuredKeyway(6, 34, 20)}));
    EXPECT_EQ(all.count("italic: as measured; not a specification. ± U: k = 2; no ±: U is not known"), 1U);
    EXPECT_EQ(std::count_if(all.begin(), all.end(),
                            [](const std::string& text) { return text.find("specification") != std::string::npos; }),
              1);
}

TEST(MeasuredMarks, EndsAtAShoulderAreThoseOfTheRow)
{
    const Shaft shaft = measuredShaft({measuredFlat(40.44, 99.56, 0, 15)});
    const Shaft settled = withSettledMarks(shaft);
    EXPECT_DOUBLE_EQ(*settled.marks[0].z_start_mm, 40);
    EXPECT_DOUBLE_EQ(*settled.marks[0].z_end_mm, 100);
    const std::multiset<std::string> all = textsOf(shaft);
    EXPECT_THAT(all, Contains("40.000 ±0.008"));
    EXPECT_THAT(all, Not(Contains("40.44 ±0.13")));
    EXPECT_THAT(all, Contains("32.500 ±0.006"));
    // Stated by a person, 0.44 mm are 0.44 mm; and 0.6 mm are no shoulder.
    Shaft stated = shaft;
    stated.recovered = {};
    stated.marks[0].uncertainty_mm.reset();
    EXPECT_DOUBLE_EQ(*withSettledMarks(stated).marks[0].z_start_mm, 40.44);
    EXPECT_DOUBLE_EQ(*withSettledMarks(measuredShaft({measuredFlat(40.6, 90, 0, 15)})).marks[0].z_start_mm, 40.6);
}

TEST(MeasuredMarks, OppositeFlatsAreDimensionedAcross)
{
    Shaft shaft = measuredShaft({measuredFlat(6, 30, 0, 10), measuredFlat(6, 30, 180, 9)});
    std::multiset<std::string> all = textsOf(shaft);
    EXPECT_EQ(all.count("19.000 ±0.008"), 1U);  // 10 + 9, 0.006·√2
    EXPECT_EQ(std::count_if(all.begin(), all.end(),
                            [](const std::string& text) { return text.find("180") != std::string::npos; }),
              0);
    const Features features = featuresOf(shaft, {});
    ASSERT_EQ(features.sections.size(), 1U);
    // The dimension line runs from flat to flat, at 2:1.
    const Drawing section = sectionDrawing(features.sections[0], "A-A", 2, 3.5);
    EXPECT_TRUE(std::any_of(section.lines.begin(), section.lines.end(), [](const Line& line) {
        return line.layer == Layer::Dimensions && std::abs((line.to_mm - line.from_mm).norm() - 38) < 1e-6 &&
               std::abs(line.from_mm.y() - line.to_mm.y()) < 1e-9;
    }));
    shaft.marks.pop_back();
    all = textsOf(shaft);
    EXPECT_EQ(all.count("22.500 ±0.006"), 1U);  // to the round side
}

TEST(MeasuredMarks, BlindHolesSayWhatIsKnownOfTheirDepth)
{
    ShaftMark hole = measured(MarkKind::CrossHole, 11, 19, 0);
    hole.diameter_mm = 8;
    hole.through = 0;
    EXPECT_THAT(textsOf(measuredShaft({hole})), Contains("⌀8.00 ±0.18, blind, depth not known"));
    hole.depth_mm = 10;
    EXPECT_THAT(textsOf(measuredShaft({hole})), Contains("⌀8.00 ±0.18, 10.000 ±0.006 deep"));
    hole.through = 1;
    EXPECT_THAT(textsOf(measuredShaft({hole})), Contains("⌀8.00 ±0.18, through"));
    EXPECT_THAT(textsOf(measuredShaft({hole})), Contains("15.00 ±0.13"));
}

ShaftMark measuredBolts(double angle_deg)
{
    ShaftMark bolts = measured(MarkKind::BoltCircle, 100, 131, angle_deg);
    bolts.count = 3;
    bolts.diameter_mm = 4;
    bolts.pitch_circle_mm = 20;
    bolts.through = 1;
    return bolts;
}

TEST(MeasuredMarks, CirclesOfHolesAreTurnedUpOrHaveAnAngle)
{
    EXPECT_THAT(textsOf(measuredShaft({measuredBolts(100)})), Contains("3×⌀4.00 ±0.18 on ⌀20.00 ±0.13, through"));
    const Features alone = featuresOf(measuredShaft({measuredBolts(100)}), {});
    // One of three holes is above: at 90° against the turning sense.
    EXPECT_NEAR(std::remainder(alone.sections.at(0).circles.at(0).angle_deg + 90, 120), 0, 1e-9);
    // Beside a keyway the nearest hole: 100° - 20° - 120°.
    EXPECT_THAT(textsOf(measuredShaft({measuredKeyway(6, 34, 20), measuredBolts(100)})), Contains("40.0° ±0.3°"));
}

std::vector<Line> dashed(const Drawing& drawing)
{
    std::vector<Line> found;
    for (const Line& line : drawing.lines)
        if (line.type == LineType::Dashed) found.push_back(line);
    return found;
}

TEST(MeasuredMarks, WhatLiesBehindIsDashed)
{
    const Shaft shaft = measuredShaft({measuredKeyway(6, 34, 0), measuredKeyway(50, 85, 150)});
    const std::vector<Line> lines = dashed(viewOf(shaft, 1));
    ASSERT_FALSE(lines.empty());
    for (const Line& line : lines) {
        EXPECT_GE(std::min(line.from_mm.x(), line.to_mm.x()), 50 - 1e-9);
        EXPECT_LE(std::max(line.from_mm.x(), line.to_mm.x()), 85 + 1e-9);
    }
    EXPECT_TRUE(dashed(viewOf(measuredShaft({measuredKeyway(6, 34, 0)}), 1)).empty());
    for (const double angle_deg : {100.0, 120.0, 150.0, 180.0, -135.0}) {
        const Drawing drawing =
            drawShaft(measuredShaft({measuredKeyway(6, 34, 0), measuredKeyway(50, 85, angle_deg)}), {});
        EXPECT_TRUE(drawing.complete);
        EXPECT_THAT(overlappingTexts(drawing), IsEmpty()) << angle_deg;
        EXPECT_THAT(crossedTexts(drawing), IsEmpty()) << angle_deg;
    }
}

TEST(MeasuredMarks, ExtensionLinesBeginAtTheMark)
{
    const Features features = featuresOf(measuredShaft({measuredKeyway(6, 34, 0), measuredKeyway(50, 85, 150)}), {});
    const auto radiusAt = [&](double z_mm) {
        for (const LengthDimension& length : features.lengths)
            if (std::abs(length.to_z_mm - z_mm) < 1e-9) return length.to_radius_mm;
        return -1e9;
    };
    EXPECT_NEAR(radiusAt(6), 4, 1e-9);
    EXPECT_NEAR(radiusAt(50), 17.5 * 0.5 + 4 * std::sqrt(0.75), 1e-9);
}

TEST(MeasuredMarks, ASquareInTheMidstOfACylinderLeavesTheRestItsDiameter)
{
    ShaftMark square = measured(MarkKind::Square, 5, 22, 0);
    square.across_flats_mm = 19;
    square.uncertainty_mm = 0.004;
    const Shaft shaft = measuredShaft({square});
    const std::multiset<std::string> all = textsOf(shaft);
    for (const char* text : {"⌀25.000 ±0.002", "AF 19.000 ±0.004", "corners ⌀25.000 ±0.002", "5.00 ±0.13"})
        EXPECT_THAT(all, Contains(text));
    const Features features = featuresOf(shaft, {});
    EXPECT_DOUBLE_EQ(features.diameters.at(0).from_z_mm, 22);
    EXPECT_DOUBLE_EQ(features.diameters.at(0).to_z_mm, 40);
    // Along the square the outline is its face, not the cylinder.
    const Drawing view = viewOf(shaft, 1);
    EXPECT_FALSE(std::any_of(view.lines.begin(), view.lines.end(), [](const Line& line) {
        const auto [from, to] = std::minmax(line.from_mm.x(), line.to_mm.x());
        return std::abs(line.from_mm.y() - 12.5) < 1e-9 && std::abs(line.to_mm.y() - 12.5) < 1e-9 && from < 21.9 &&
               to > 5.1;
    }));
}

TEST(MeasuredMarks, ASplineHasItsLengthAndBothDiametersWithU)
{
    ShaftMark spline = measured(MarkKind::Spline, 0, 30, 0);
    spline.teeth = 10;
    spline.major_mm = 25;
    spline.minor_mm = 22;
    spline.uncertainty_mm = 0.008;
    const Shaft shaft = measuredShaft({spline});
    const std::multiset<std::string> all = textsOf(shaft);
    for (const char* text : {"⌀25.000 ±0.008 / ⌀22.000 ±0.006", "30.00 ±0.13", "spline 10×22×25"})
        EXPECT_THAT(all, Contains(text));
    for (const Label& label : drawShaft(shaft, {}).labels)
        if (label.text == "spline 10×22×25") {
            EXPECT_TRUE(label.italic);
        }
    // Its end in the midst of the row is a line across.
    double end_mm = 0;
    for (const Line& line : viewOf(shaft, 1).lines)
        if (std::abs(line.from_mm.x() - 30) < 1e-9 && std::abs(line.to_mm.x() - 30) < 1e-9)
            end_mm += std::abs(line.from_mm.y() - line.to_mm.y());
    EXPECT_NEAR(end_mm, 25, 1e-9);
}

TEST(MeasuredMarks, ACrownHasADiameter)
{
    // Sagitta 0.3 of a chord of 80: R = (40² + 0.3²)/(2·0.3).
    Shaft shaft = measuredShaft({});
    const double radius = (40.0 * 40 + 0.09) / 0.6;
    ShaftSegment crown{80, 49.4, 49.4, 0, radius, ""};
    crown.measured = MeasuredSize{80.0, 49.4, 49.4, radius, {}};
    crown.measured->uncertainty.start_diameter_um = crown.measured->uncertainty.end_diameter_um = 2;
    crown.measured->uncertainty.arc_radius_um = 3800;
    shaft.segments[1] = crown;
    EXPECT_NEAR(outerRows(shaft)[1].crestDiameter_mm(), 50, 1e-9);
    EXPECT_THAT(textsOf(shaft), Contains("R2666.8 ±3.8, ⌀50.000 ±0.002 (⌀49.4 - ⌀49.4)"));
}

TEST(MeasuredMarks, AStatedLengthIsNoMeasuredOne)
{
    Shaft shaft = measuredShaft({});
    EXPECT_THAT(textsOf(shaft), Contains("131.000 ±0.008"));
    shaft.recovered.stated_length_mm = 131;
    const Drawing drawing = drawShaft(shaft, {});
    EXPECT_THAT(textsOf(drawing), Not(Contains("131.000 ±0.008")));
    EXPECT_THAT(textsOf(drawing), Contains("The length of 131 mm was stated; an end is not seen."));
    for (const Label& label : drawing.labels)
        if (label.text == "131") {
            EXPECT_FALSE(label.italic);
        }
    EXPECT_THAT(textsOf(drawing), Contains("131"));
}

TEST(MeasuredMarks, WhatIsUnexplainedOnAFaceHasOnePlace)
{
    EXPECT_THAT(textsOf(measuredShaft({measured(MarkKind::Unexplained, 40, 40, 0)})), Contains("NOT EXPLAINED, z 40"));
    EXPECT_THAT(textsOf(measuredShaft({measured(MarkKind::Unexplained, 40, 42, 0)})),
                Contains("NOT EXPLAINED, z 40-42"));
}

}  // namespace
}  // namespace lathelier::drawing
