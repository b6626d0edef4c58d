// Drawings of parts with keyways, holes, bolt circles, prisms, splines, eccentrics and balls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/drawing/difference_table.h"
#include "engine/drawing/features.h"
#include "engine/drawing/marks/section_drawing.h"
#include "engine/drawing/marks/section_outline.h"
#include "engine/drawing/marks/view_marks.h"
#include "engine/drawing/rows.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/drawing/view.h"
#include "placement.h"

namespace lathelier::drawing {
namespace {

using testing::Contains;
using testing::IsEmpty;

ShaftMark markOf(MarkKind kind, double from_mm, double to_mm, double angle_deg)
{
    ShaftMark mark{kind};
    mark.z_start_mm = from_mm;
    mark.z_end_mm = to_mm;
    mark.angle_deg = angle_deg;
    return mark;
}

ShaftMark keyway(double from_mm, double to_mm, double angle_deg, double width_mm, double floor_mm)
{
    ShaftMark mark = markOf(MarkKind::Keyway, from_mm, to_mm, angle_deg);
    mark.width_mm = width_mm;
    mark.floor_mm = floor_mm;
    return mark;
}

ShaftMark hole(double z_mm, double diameter_mm, double angle_deg, std::optional<double> depth_mm)
{
    ShaftMark mark = markOf(MarkKind::CrossHole, z_mm - diameter_mm / 2, z_mm + diameter_mm / 2, angle_deg);
    mark.diameter_mm = diameter_mm;
    mark.depth_mm = depth_mm;
    mark.through = depth_mm ? 0 : 1;
    return mark;
}

ShaftMark prism(MarkKind kind, double from_mm, double to_mm, double across_mm)
{
    ShaftMark mark = markOf(kind, from_mm, to_mm, 0);
    mark.across_flats_mm = across_mm;
    return mark;
}

ShaftMark spline(double from_mm, double to_mm)
{
    ShaftMark mark = markOf(MarkKind::Spline, from_mm, to_mm, 0);
    mark.teeth = 6;
    mark.minor_mm = 23;
    mark.major_mm = 28;
    mark.width_mm = 6;
    return mark;
}

ShaftMark eccentric(double from_mm, double to_mm, double angle_deg)
{
    ShaftMark mark = markOf(MarkKind::Eccentric, from_mm, to_mm, angle_deg);
    mark.offset_mm = 2;
    mark.diameter_mm = 40;
    mark.uncertainty_mm = 0.001;
    return mark;
}

ShaftMark boltCircle()
{
    ShaftMark mark = markOf(MarkKind::BoltCircle, 0, 12, 30);
    mark.count = 6;
    mark.diameter_mm = 11;
    mark.pitch_circle_mm = 60;
    mark.through = 1;
    return mark;
}

Shaft shaftOf(std::vector<std::pair<double, double>> rows, std::vector<ShaftMark> marks)
{
    Shaft shaft;
    shaft.name = "part";
    for (const auto& [length_mm, diameter_mm] : rows)
        shaft.segments.push_back({length_mm, diameter_mm, diameter_mm, 0, {}, ""});
    shaft.marks = std::move(marks);
    return shaft;
}

std::map<std::string, Shaft> oddParts()
{
    const std::vector<std::pair<double, double>> stepped{{40, 25}, {60, 35}, {31, 30}};
    std::map<std::string, Shaft> parts;
    parts["keys at 90"] = shaftOf(stepped, {keyway(6, 34, 20, 8, 8.5), keyway(104, 126, 110, 6, 11.5)});
    parts["keys at 37"] = shaftOf(stepped, {keyway(6, 34, 0, 8, 8.5), keyway(50, 85, 37.5, 10, 12.5)});
    parts["keys opposite"] = shaftOf(stepped, {keyway(50, 85, 0, 10, 12.5), keyway(50, 85, 180, 10, 12.5)});
    parts["holes"] = shaftOf(stepped, {hole(15, 6, 0, {}), hole(30, 5, 90, 12), hole(80, 8, 45, {})});
    parts["bored holes"] = parts["holes"];
    parts["bored holes"].bores = {{ShaftEnd::Free, {{131, 12, 12, {}, ""}}}};
    parts["flange"] = shaftOf({{12, 90}, {40, 40}}, {boltCircle()});
    parts["bolt"] = shaftOf({{12, 21.94}, {20, 16}, {30, 12}}, {prism(MarkKind::Hexagon, 0, 12, 19)});
    parts["tap"] = shaftOf({{14, 22.4}, {40, 25}}, {prism(MarkKind::Square, 0, 14, 18)});
    parts["splined"] = shaftOf({{51, 28}, {30, 35}}, {spline(0, 51)});
    parts["cam"] = shaftOf({{30, 20}, {15, 40}, {40, 25}}, {eccentric(30, 45, 15)});
    parts["cam with key"] =
        shaftOf({{30, 20}, {15, 40}, {40, 25}}, {keyway(52, 80, 0, 8, 8.5), eccentric(30, 45, 120)});
    parts["everything"] =
        shaftOf({{15, 21.94}, {30, 30}, {15, 40}, {50, 35}, {40, 28}, {20, 20}},
                {prism(MarkKind::Hexagon, 0, 15, 19), keyway(18, 42, 90, 8, 11), eccentric(45, 60, 30),
                 keyway(65, 105, 180, 10, 12.5), spline(110, 150), hole(161, 6, 45, {})});
    return parts;
}

std::multiset<std::string> texts(const Drawing& drawing)
{
    std::multiset<std::string> all;
    for (const Label& label : drawing.labels) all.insert(label.text);
    return all;
}

TEST(MarksDrawing, EachKeywayIsDimensionedInItsSection)
{
    const std::multiset<std::string> all = texts(drawShaft(oddParts().at("keys at 90"), {}));
    for (const char* text : {"A-A", "B-B", "8", "6", "21", "26.5", "90°", "(length 28)", "(length 22)", "104", "126"})
        EXPECT_THAT(all, Contains(text));
}

TEST(MarksDrawing, MarksOfOnePlaceShareASection)
{
    const Drawing drawing = drawShaft(oddParts().at("keys opposite"), {});
    const std::multiset<std::string> all = texts(drawing);
    EXPECT_EQ(all.count("A-A"), 1U);
    EXPECT_EQ(all.count("10"), 2U);
    EXPECT_EQ(all.count("30"), 2U);
    EXPECT_EQ(all.count("180°"), 1U);
    EXPECT_EQ(all.count("B-B"), 0U);
}

TEST(MarksDrawing, EachKindIsNamedWithItsSizes)
{
    const auto parts = oddParts();
    const auto of = [&](const char* name) { return texts(drawShaft(parts.at(name), {})); };
    for (const char* text : {"⌀6, through", "⌀5, 12 deep", "⌀8, through", "45°", "15", "80"})
        EXPECT_THAT(of("holes"), Contains(text));
    EXPECT_THAT(of("flange"), Contains("6×⌀11 on ⌀60, through"));
    EXPECT_THAT(of("bolt"), Contains("AF 19"));
    EXPECT_THAT(of("bolt"), Contains("hexagon"));
    EXPECT_EQ(of("bolt").count("⌀21.94"), 0U);  // no cylinder
    EXPECT_THAT(of("tap"), Contains("AF 18"));
    EXPECT_THAT(of("splined"), Contains("spline 6×23×28"));
    EXPECT_THAT(of("cam"), Contains("e 2.000 ±0.001"));
    EXPECT_THAT(of("cam with key"), Contains("120°"));
    Shaft ball = shaftOf({}, {markOf(MarkKind::Sphere, 0, 7.5, 0)});
    ball.segments = {{7.5, 0, 2 * std::sqrt(168.75 - 0.0), 0, 15.0, ""}};
    ball.segments[0].end_diameter_mm = 2 * std::sqrt(15.0 * 15.0 - 7.5 * 7.5);
    ball.segments.push_back({40, ball.segments[0].end_diameter_mm, ball.segments[0].end_diameter_mm, 0, {}, ""});
    EXPECT_THAT(texts(drawShaft(ball, {})), Contains("SR15"));
}

TEST(MarksDrawing, EveryPartCanBeReadOnEverySheet)
{
    for (const auto& [name, shaft] : oddParts())
        for (const std::optional<Sheet> sheet : {std::optional<Sheet>(), std::optional(Sheet::A4Landscape),
                                                 std::optional(Sheet::A4Portrait), std::optional(Sheet::A3Landscape)}) {
            SCOPED_TRACE(name + (sheet ? std::to_string(static_cast<int>(*sheet)) : ""));
            DrawingOptions options;
            options.sheet = sheet;
            const Drawing drawing = drawShaft(shaft, options);
            // Six sections find no room on A4, which is said.
            const bool too_small = name == "everything" && sheet && *sheet != Sheet::A3Landscape;
            EXPECT_EQ(drawing.complete, !too_small);
            EXPECT_EQ(texts(drawing).count("INCOMPLETE: the sheet is too small for the dimensions and sections"),
                      too_small ? 1U : 0U);
            EXPECT_THAT(overlappingTexts(drawing), IsEmpty());
            EXPECT_THAT(crossedTexts(drawing), IsEmpty());
            EXPECT_TRUE(frameBox(drawing.sheet).contains(boxOf(drawing)));
        }
}

/// The outline's lines and arcs, without hatching.
double edgeLength(const Drawing& outline)
{
    double sum = 0;
    for (const Line& line : outline.lines)
        if (line.layer == Layer::Contour) sum += (line.to_mm - line.from_mm).norm();
    for (const Arc& arc : outline.arcs)
        if (arc.layer == Layer::Contour) sum += arc.radius_mm * (arc.end_deg - arc.start_deg) * std::acos(-1.0) / 180;
    return sum;
}

TEST(MarksDrawing, OutlinesOfSectionsAreExact)
{
    const double pi = std::acos(-1.0);
    CrossSection keyed{0, 10, 40, 0};
    keyed.slots.push_back({30, 12, 15, {}, {}, {}});
    const double half_rad = std::asin(6.0 / 20), side = std::sqrt(20.0 * 20 - 6 * 6);
    EXPECT_NEAR(edgeLength(sectionOutline(keyed, 1)), 20 * (2 * pi - 2 * half_rad) + 12 + 2 * (side - 15), 1e-6);
    CrossSection hexagon{0, 10, 22, 0};
    for (int i = 0; i < 6; ++i) hexagon.flats.push_back({60.0 * i + 7, 9.5, {}, {}});
    // Corners at 10.97 mm lie within the circle of 11 mm: six sides of AF/√3.
    EXPECT_NEAR(edgeLength(sectionOutline(hexagon, 1)), 6 * 19 / std::sqrt(3.0), 1e-4);
    hexagon.diameter_mm = 21;  // turned corners
    const double half = std::sqrt(10.5 * 10.5 - 9.5 * 9.5), left_rad = pi / 6 - std::acos(9.5 / 10.5);
    EXPECT_NEAR(edgeLength(sectionOutline(hexagon, 1)), 12 * half + 12 * 10.5 * left_rad, 1e-4);
}

TEST(MarksDrawing, SectionsShowEachMarkWhereItIs)
{
    // Toward the viewer is right; a quarter turn further is below (first angle, seen from the free end).
    const Features features = featuresOf(oddParts().at("keys at 90"), {});
    ASSERT_EQ(features.sections.size(), 2U);
    EXPECT_NEAR(features.sections[0].slots.at(0).angle_deg, 0, 1e-9);
    EXPECT_NEAR(features.sections[1].slots.at(0).angle_deg, 90, 1e-9);
    EXPECT_NEAR(directionOf(0).x(), 1, 1e-12);
    EXPECT_NEAR(directionOf(90).y(), -1, 1e-12);
    double lowest = 0;
    for (const Line& line : sectionOutline(features.sections[1], 1).lines)
        if (line.layer == Layer::Contour) lowest = std::min({lowest, line.from_mm.y(), line.to_mm.y()});
    EXPECT_NEAR(lowest, -std::sqrt(15.0 * 15 - 3 * 3), 1e-9);
}

TEST(MarksDrawing, PrismsAndEccentricsHaveTheirSilhouette)
{
    const auto parts = oddParts();
    const ShapedStretch hexagon = shapedStretches(parts.at("bolt")).at(0);
    EXPECT_NEAR(hexagon.high_mm, 19 / std::sqrt(3.0), 1e-9);  // a corner is above where a face is seen
    const ShapedStretch cam = shapedStretches(parts.at("cam")).at(0);
    EXPECT_NEAR(cam.high_mm, 22, 1e-9);
    EXPECT_NEAR(cam.low_mm, -18, 1e-9);
    const Box view = boxOf(viewOf(parts.at("cam"), 1));
    EXPECT_NEAR(view.top_mm, 22, 1e-9);
    EXPECT_NEAR(view.bottom_mm, -18, 1e-9);
    const Box tap = boxOf(viewOf(shaftOf({{14, 22.4}}, {prism(MarkKind::Square, 0, 14, 18)}), 1));
    EXPECT_NEAR(tap.top_mm, 9, 1e-9);
}

TEST(MarksDrawing, SmallSectionsAreEnlarged)
{
    const Scale half{1, 2};
    EXPECT_EQ(sectionScale({0, 1, 60, 0}, half), half);
    EXPECT_EQ(sectionScale({0, 1, 30, 0}, half), (Scale{1, 1}));
    EXPECT_EQ(sectionScale({0, 1, 200, 0}, half), (Scale{1, 5}));
}

TEST(TitleBlock, SaysWhatAPersonAdds)
{
    Shaft shaft = oddParts().at("tap");
    shaft.material = Material{"C45"};
    shaft.general_tolerance = "ISO 2768-m";
    DrawingOptions options;
    options.author = "A. Turner";
    options.surface_texture = "Rz 16";
    options.date = "2026-11-27";
    const Drawing drawing = drawShaft(shaft, options);
    for (const char* text :
         {"A. Turner", "Rz 16", "2026-11-27", "C45", "ISO 2768-m", "Projection", "Mass without marks"})
        EXPECT_THAT(texts(drawing), Contains(text));
    // The symbol of first-angle projection: two circles right of the cone whose small end is left.
    std::vector<Arc> circles;
    for (const Arc& arc : drawing.arcs)
        if (arc.layer == Layer::Frame) circles.push_back(arc);
    ASSERT_EQ(circles.size(), 2U);
    EXPECT_EQ(circles[0].centre_mm, circles[1].centre_mm);
    EXPECT_LT(circles[0].radius_mm, circles[1].radius_mm);
    for (const char* text : {"Material", "Author", "General tolerances", "Surface texture"})
        EXPECT_THAT(texts(drawShaft(oddParts().at("tap"), {})), Contains(text));
}

TEST(DifferenceTable, StandsWithinTheSheetBesideOrAboveTheBlock)
{
    for (const std::size_t count : {std::size_t{1}, std::size_t{14}, std::size_t{40}})
        for (const Sheet sheet : {Sheet::A4Landscape, Sheet::A4Portrait, Sheet::A3Landscape}) {
            const std::vector<Difference> differences(count, {"⌀25 k5 (+0.011/+0.002)", 25, 25.009, 1.2});
            const Drawing table = differenceTable(differences, {}, sheet, 50);
            EXPECT_TRUE(frameBox(sheet).contains(boxOf(table)));
            EXPECT_EQ(texts(table).count("25.009 ±0.001"), count);
            EXPECT_EQ(texts(table).count("+0.009"), count);
            EXPECT_THAT(overlappingTexts(table), IsEmpty());
            if (sheet == Sheet::A4Portrait) {
                EXPECT_GE(boxOf(table).bottom_mm, frameBox(sheet).bottom_mm + 50 - 1e-9);
            }
        }
    EXPECT_TRUE(differenceTable({}, {}, Sheet::A4Landscape, 50).lines.empty());
}

TEST(DifferenceTable, HasALineForEachNumberInTheDrawing)
{
    Shaft shaft = shaftOf({{40, 25}, {60, 35}}, {});
    SizeUncertainty known;
    known.start_diameter_um = 1;
    known.z_start_um = known.z_end_um = 6;
    shaft.segments[0].measured = MeasuredSize{39.996, 25.009, 25.009, {}, known};
    shaft.segments[0].tolerance = SizeTolerance{"k5", 2.0, 11.0};
    shaft.segments[1].measured = MeasuredSize{60.0, 35.0, 35.0, {}, known};
    const std::multiset<std::string> all = texts(drawShaft(shaft, {}));
    for (const char* text : {"⌀25 k5 (+0.011/+0.002) [1]", "25.009 ±0.001", "+0.009", "⌀35.000 ±0.001", "40 [2]",
                             "39.996 ±0.008", "−0.004", "100 [3]", "99.996 ±0.008",
                             "italic: as measured; not a specification. ± U: k = 2; no ±: U is not known"})
        EXPECT_THAT(all, Contains(text));
}

}  // namespace
}  // namespace lathelier::drawing
