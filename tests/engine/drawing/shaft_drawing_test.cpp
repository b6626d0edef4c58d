// Drawings of the six parts: their texts, and legibility.
#include "engine/drawing/shaft_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "engine/drawing/features.h"
#include "engine/drawing/marks/section_outline.h"
#include "engine/drawing/rows.h"
#include "engine/drawing/view.h"
#include "engine/shaft/shaft_contour.h"
#include "placement.h"
#include "six_parts.h"

namespace lathelier::drawing {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Texts of dimensions, sorted.
std::multiset<std::string> dimensions(const Drawing& drawing)
{
    std::multiset<std::string> texts;
    for (const Label& label : drawing.labels)
        if (label.layer == Layer::Dimensions) texts.insert(label.text);
    return texts;
}

bool says(const Drawing& drawing, const std::string& text)
{
    return std::any_of(drawing.labels.begin(), drawing.labels.end(),
                       [&](const Label& label) { return label.text == text; });
}

DrawingOptions measuredOptions(const Shaft& shaft)
{
    DrawingOptions options;
    options.measured = true;
    options.date = "2026-03-02";
    SizeUncertainty uncertainty;
    uncertainty.z_start_um = 9;
    uncertainty.z_end_um = 12;
    uncertainty.start_diameter_um = 4;
    uncertainty.arc_radius_um = 30;
    options.uncertainties.assign(shaft.segments.size(), uncertainty);
    return options;
}

TEST(ShaftDrawing, Table1SaysEachSizeOnce)
{
    const Drawing drawing = drawShaft(table1Part(), {});
    EXPECT_THAT(dimensions(drawing), ElementsAre("108", "183", "5×45°", "98", "⌀30", "⌀33.8", "⌀37"));
    EXPECT_EQ(drawing.scale, (Scale{1, 1}));
    EXPECT_TRUE(says(drawing, "1.15 kg"));
    EXPECT_TRUE(says(drawing, "11SMn30 (1.0715)"));
    EXPECT_FALSE(says(drawing, "italic: as measured; not a specification. ± U: k = 2; no ±: U is not known"));
}

TEST(ShaftDrawing, BallsAtTheEnds)
{
    // SR of half a ball or less, S⌀ of more.
    Shaft pin;
    pin.segments = {{18, 0, 12, 0, 10.0, {}}, {25, 12, 12, 0, {}, {}}, {15, 18, 18, 0, {}, {}}, {9, 18, 0, 0, 9.0, {}}};
    const std::multiset<std::string> texts = dimensions(drawShaft(pin, {}));
    EXPECT_EQ(texts.count("S⌀20"), 1U);
    EXPECT_EQ(texts.count("SR9"), 1U);
}

TEST(ShaftDrawing, UndercutsAreNamed)
{
    EXPECT_THAT(dimensions(drawShaft(undercutPart(), {})),
                ElementsAre("0.5×45°", "0.5×45°", "1.3×⌀19", "1.5×45°", "118", "12", "142", "1×45°", "40", "70", "80",
                            "DIN 509 - E 0.6×0.2", "DIN 509 - F 0.8×0.3", "R1", "⌀17", "⌀20", "⌀25", "⌀25", "⌀34"));
}

TEST(ShaftDrawing, TapersSayTheirRatioOrTheirAngle)
{
    EXPECT_THAT(
        dimensions(drawShaft(taperPart(), {})),
        ElementsAre("119.3", "128.3", "131.764", "144.764", "1×45°", "20.8", "40.8", "60° ⌀30 (3.464)", "80.8", "87.3",
                    "95.3", "R0.8", "R1", "R2.5", "R3", "R60", "⌀16", "⌀24", "⌀26", "⌀28", "⌀42", "⌀42", "▷1:10 (40)"));
}

TEST(ShaftDrawing, AKeywayGetsItsSection)
{
    const Drawing drawing = drawShaft(keywayPart(), {});
    EXPECT_THAT(dimensions(drawing),
                ElementsAre("(length 40)", "1.5×45°", "10", "126", "157.5", "1×45°", "26", "50", "61", "8", "86", "92",
                            "A", "A", "R1", "⌀30", "⌀35", "⌀35.01", "⌀40", "⌀46"));
    EXPECT_TRUE(says(drawing, "A-A"));
}

TEST(ShaftDrawing, BoresAreDimensionedFromTheirMouth)
{
    const Drawing drawing = drawShaft(flangePart(), {});
    EXPECT_THAT(dimensions(drawing), ElementsAre("18", "1×45°", "1×45°", "1×45°", "2×45°", "31.6", "38.6", "47.6",
                                                 "R1.6", "⌀110", "⌀32", "⌀40", "⌀47", "⌀60"));
}

TEST(ShaftDrawing, ThreadsAndKnurls)
{
    EXPECT_THAT(dimensions(drawShaft(threadPart(), {})), ElementsAre("1.5×45°", "1×45°", "32", "4×⌀13.2", "54", "85",
                                                                     "M16×2 - 28", "knurl, 60 teeth", "⌀18", "⌀24"));
    Shaft shaft = threadPart();
    shaft.marks[0].designation = "M16";
    shaft.marks[1].designation = "DIN 82 RGE 1.25";
    const Drawing drawing = drawShaft(shaft, {});
    EXPECT_TRUE(says(drawing, "M16 - 28"));
    EXPECT_TRUE(says(drawing, "DIN 82 RGE 1.25"));
}

TEST(ShaftDrawing, EveryPartCanBeReadOnEverySheet)
{
    for (const auto& [name, shaft] : allParts())
        for (const std::optional<Sheet> sheet : {std::optional<Sheet>(), std::optional(Sheet::A4Landscape),
                                                 std::optional(Sheet::A4Portrait), std::optional(Sheet::A3Landscape)})
            for (const bool measured : {false, true}) {
                SCOPED_TRACE(name + (sheet ? std::to_string(static_cast<int>(*sheet)) : "") + (measured ? "m" : ""));
                DrawingOptions options = measured ? measuredOptions(shaft) : DrawingOptions{};
                options.sheet = sheet;
                const Drawing drawing = drawShaft(shaft, options);
                EXPECT_TRUE(drawing.complete);
                EXPECT_THAT(overlappingTexts(drawing), IsEmpty());
                EXPECT_THAT(crossedTexts(drawing), IsEmpty());
                EXPECT_TRUE(frameBox(drawing.sheet).contains(boxOf(drawing)));
                if (sheet) {
                    EXPECT_EQ(drawing.sheet, *sheet);
                }
                EXPECT_GE(std::max(boxOf(viewOf(shaft, 1)).height_mm(), shaft.length_mm()) * drawing.scale.factor(),
                          50);
                EXPECT_NE(std::find(scales().begin(), scales().end(), drawing.scale), scales().end());
                EXPECT_EQ(drawing, drawShaft(shaft, options));
            }
}

TEST(ShaftDrawing, TheViewHasTheSizeOfTheScale)
{
    for (const auto& [name, shaft] : allParts()) {
        SCOPED_TRACE(name);
        const Drawing view = viewOf(shaft, 2);
        double largest = 0;
        for (const ShaftSegment& row : shaft.segments)
            largest = std::max({largest, row.start_diameter_mm, row.end_diameter_mm});
        EXPECT_NEAR(boxOf(view).width_mm(), 2 * shaft.length_mm(), 1e-6);
        EXPECT_NEAR(boxOf(view).height_mm(), 2 * largest, 1e-6);
    }
}

TEST(ShaftDrawing, OnlyMaterialIsHatched)
{
    for (const auto& [name, shaft] : allParts()) {
        SCOPED_TRACE(name);
        int lines = 0;
        for (const Line& line : viewOf(shaft, 1).lines) {
            if (line.layer != Layer::Hatch) continue;
            ++lines;
            const Eigen::Vector2d middle = (line.from_mm + line.to_mm) / 2;
            EXPECT_GT(middle.y(), 0);  // the upper half is cut
            int above = 0;             // of the flange's outside and bore, straight pieces in the main
            for (const ContourPiece& piece : closedContour(shaft)) {
                const double a = piece.from_mm.x() - middle.x(), b = piece.to_mm.x() - middle.x();
                if ((a < 0) != (b < 0) && piece.radiusAt_mm(middle.x()) > middle.y()) ++above;
            }
            EXPECT_EQ(above % 2, 1);
        }
        EXPECT_EQ(lines > 0, !shaft.bores.empty());
    }
}

TEST(ShaftDrawing, MassIsThatOfTheVolume)
{
    const std::map<std::string, double> volumes_mm3 = {{"table1", 146123.06650070747}, {"undercut", 60260.850864577085},
                                                       {"taper", 101680.76147928408},  {"keyway", 147397.0653920597},
                                                       {"flange", 185788.5709091718},  {"thread", 25709.84656319503}};
    for (const auto& [name, shaft] : allParts()) {
        EXPECT_NEAR(massInKilograms(shaft).value() / 7.85e-6, volumes_mm3.at(name), 1e-6 * volumes_mm3.at(name))
            << name;
    }
    Shaft unknown = table1Part();
    unknown.material.reset();
    EXPECT_FALSE(massInKilograms(unknown));
}

TEST(ShaftDrawing, MeasuredSizesAreItalicAndNominalOnesUpright)
{
    Shaft shaft = table1Part();
    shaft.recovered = {"part.xyz", std::string(64, '5'), "robust"};
    shaft.segments[0].measured = MeasuredSize{98.012, 30.007, 30.007, {}, {}};  // snapped: nominal
    shaft.segments[2].tolerance = SizeTolerance{"h6", {}, {}};
    DrawingOptions options = measuredOptions(shaft);
    options.decimal_separator = ",";
    const Drawing drawing = drawShaft(shaft, options);
    std::map<std::string, bool> italic;
    for (const Label& label : drawing.labels) italic[label.text] = label.italic;
    EXPECT_EQ(italic.at("⌀30 [1]"), false);
    EXPECT_EQ(italic.at("⌀37,000 ±0,004"), true);
    EXPECT_EQ(italic.at("⌀33,8 h6"), false);
    EXPECT_EQ(italic.at("98 [2]"), false);
    EXPECT_EQ(italic.at("+0,007"), false);  // the table of differences
    EXPECT_EQ(italic.at("30,007 ±0,004"), true);
    EXPECT_EQ(italic.at("98,012 ±0,015"), true);  // √(9² + 12²)
    EXPECT_EQ(italic.at("+0,012"), false);
    EXPECT_EQ(italic.at("108 [3]"), false);  // it begins where the replaced length ends
    EXPECT_TRUE(italic.contains("italic: as measured; not a specification. ± U: k = 2; no ±: U is not known"));
    EXPECT_TRUE(italic.contains("part.xyz"));
    EXPECT_TRUE(italic.contains(std::string(64, '5')));
}

TEST(ShaftDrawing, WordsAreTranslatedAndLongContentsFit)
{
    DrawingOptions options;
    options.translate = [](Text text) { return "«" + std::string(text.english) + "»"; };
    options.name = std::string(300, 'W');
    const Drawing drawing = drawShaft(table1Part(), options);
    EXPECT_TRUE(says(drawing, "«Mass»"));
    EXPECT_TRUE(says(drawing, "«Scale»"));
    EXPECT_THAT(overlappingTexts(drawing), IsEmpty());
    EXPECT_TRUE(frameBox(drawing.sheet).contains(boxOf(drawing)));
}

TEST(ShaftDrawing, BoreDiametersOfRowsAreBores)
{
    Shaft shaft = table1Part();
    for (ShaftSegment& row : shaft.segments) row.bore_diameter_mm = 12;
    const Shaft stated = withStatedBores(shaft);
    ASSERT_EQ(stated.bores.size(), 1U);
    ASSERT_EQ(stated.bores[0].segments.size(), 1U);
    EXPECT_NEAR(stated.bores[0].segments[0].length_mm, 183, 1e-9);
    EXPECT_NEAR(volume_mm3(stated), volume_mm3(shaft), 1e-6);
    EXPECT_EQ(dimensions(drawShaft(shaft, {})).count("⌀12"), 1U);
}

TEST(ShaftDrawing, BoresPrintTheirUncertainty)
{
    const Shaft shaft = flangePart();
    DrawingOptions options = measuredOptions(shaft);
    options.bore_uncertainties.assign(1, std::vector<SizeUncertainty>(5, options.uncertainties[0]));
    const Drawing drawing = drawShaft(shaft, options);
    EXPECT_TRUE(says(drawing, "⌀32.000 ±0.004"));
    EXPECT_TRUE(says(drawing, "18.000 ±0.015"));
    EXPECT_THAT(overlappingTexts(drawing), IsEmpty());
    EXPECT_THAT(crossedTexts(drawing), IsEmpty());
}

TEST(ShaftDrawing, AGrooveDoesNotRepeatADiameter)
{
    Shaft shaft;
    shaft.segments = {{60, 40, 40, 0, {}, ""}};
    shaft.bores = {{ShaftEnd::Chuck, {{10, 16, 16, {}, ""}, {3, 20, 20, {}, "groove"}, {5, 16, 16, {}, ""}}}};
    const std::multiset<std::string> texts = dimensions(drawShaft(shaft, {}));
    EXPECT_EQ(texts.count("⌀16"), 1U);
    EXPECT_EQ(texts.count("3×⌀20"), 1U);
    EXPECT_EQ(texts.count("18"), 1U);
}

TEST(ShaftDrawing, AnUndercutEndsAtItsShoulder)
{
    // The arc of the form F runs behind the collar's face at z = 70; what lies before it is drawn up to there.
    double last = 0;
    for (const Arc& arc : viewOf(undercutPart(), 1).arcs)
        if (std::abs(arc.radius_mm - 0.8) < 1e-9)
            for (const double angle : {arc.start_deg, arc.end_deg})
                last = std::max(last, arc.centre_mm.x() + arc.radius_mm * std::cos(angle * 3.14159265358979 / 180));
    EXPECT_NEAR(last, 70, 1e-3);
}

TEST(ShaftDrawing, AKeywayInABoredShaftShowsTheBore)
{
    Shaft shaft = keywayPart();
    shaft.bores = {{ShaftEnd::Free, {{157.5, 10, 10, {}, ""}}}};
    const Features features = featuresOf(shaft, {});
    ASSERT_EQ(features.sections.size(), 1U);
    EXPECT_EQ(features.sections[0].bore_diameter_mm, 10);
    for (const Line& line : sectionOutline(features.sections[0], 1).lines)
        if (line.layer == Layer::Hatch) {
            EXPECT_GT(((line.from_mm + line.to_mm) / 2).norm(), 4.9);
        }
    EXPECT_THAT(overlappingTexts(drawShaft(shaft, {})), IsEmpty());
}

TEST(ShaftDrawing, AnyShaftCanBeRead)
{
    std::mt19937 random(11);
    const auto uniform = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
    };
    for (int run = 0; run < 60; ++run) {
        SCOPED_TRACE(run);
        Shaft shaft;
        const int rows = static_cast<int>(uniform(1, 9));
        for (int i = 0; i < rows; ++i) {
            const double diameter = std::round(uniform(8, 90)), length = std::round(uniform(4, 60));
            const int kind = static_cast<int>(uniform(0, 5));
            if (kind == 0) shaft.segments.push_back({1, diameter - 2, diameter, 0, {}, "chamfer"});
            shaft.segments.push_back({length, diameter, diameter, 0, {}, ""});
            if (kind == 1) shaft.segments.push_back({2, diameter, diameter + 4, 0, -2.0, "fillet"});
            if (kind == 2) shaft.segments.push_back({1.5, diameter - 1, diameter - 1, 0, {}, "groove"});
            if (kind == 2) shaft.segments.push_back({length, diameter, diameter, 0, {}, ""});
            if (kind == 3) shaft.segments.push_back({length, diameter, diameter * 1.1, 0, {}, "taper"});
        }
        if (run % 3 == 0) shaft.bores = {{ShaftEnd::Free, {{2, 5, 5, {}, ""}, {1, 4, 0, {}, ""}}}};
        const Drawing drawing = drawShaft(shaft, run % 2 ? measuredOptions(shaft) : DrawingOptions{});
        EXPECT_TRUE(drawing.complete);
        EXPECT_THAT(overlappingTexts(drawing), IsEmpty());
        EXPECT_THAT(crossedTexts(drawing), IsEmpty());
        EXPECT_TRUE(frameBox(drawing.sheet).contains(boxOf(drawing)));
    }
}

TEST(ShaftDrawing, ExtremesDoNotLeaveTheSheet)
{
    EXPECT_FALSE(drawShaft({}, {}).labels.empty());  // an empty sheet with its title block
    for (const double size : {0.5, 5.0, 3000.0, 20000.0}) {
        Shaft shaft;
        shaft.segments = {{size, size / 5, size / 5, 0, {}, ""}, {size / 2, size / 3, size / 3, 0, {}, ""}};
        const Drawing drawing = drawShaft(shaft, {});
        EXPECT_TRUE(drawing.complete) << size;
        EXPECT_TRUE(frameBox(drawing.sheet).contains(boxOf(drawing))) << size;
    }
    Shaft many;  // 120 collars: too many for any sheet
    for (int i = 0; i < 240; ++i)
        many.segments.push_back({1.25, i % 2 ? 20.0 : 25.0 + i, i % 2 ? 20.0 : 25.0 + i, 0, {}, ""});
    const Drawing drawing = drawShaft(many, {});
    EXPECT_FALSE(drawing.complete);
    EXPECT_EQ(dimensions(drawing).count("300"), 1U);
    EXPECT_TRUE(frameBox(drawing.sheet).contains(boxOf(drawing)));
}

}  // namespace
}  // namespace lathelier::drawing
