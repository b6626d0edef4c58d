// Drawing data for editing: chains of lengths, targets of texts, position of the view.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "engine/drawing/lanes.h"
#include "engine/drawing/shaft_drawing.h"
#include "placement.h"
#include "six_parts.h"

namespace lathelier::drawing {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> lengths(const Drawing& drawing)
{
    std::vector<std::string> texts;
    for (const Label& label : drawing.labels)
        if (label.target.of == DimensionTarget::Of::Length) texts.push_back(label.text);
    return texts;
}

const Label* find(const Drawing& drawing, const std::string& text)
{
    for (const Label& label : drawing.labels)
        if (label.text == text) return &label;
    return nullptr;
}

TEST(EditedDrawing, AChainSaysEachLengthAndTheWhole)
{
    DrawingOptions options;
    EXPECT_THAT(lengths(drawShaft(table1Part(), options)), ElementsAre("98", "108", "183"));
    options.lengths_from = LengthsFrom::Previous;
    const Drawing chain = drawShaft(table1Part(), options);
    EXPECT_THAT(lengths(chain), ElementsAre("98", "10", "75", "183"));
    EXPECT_THAT(find(chain, "75")->target.rows, ElementsAre(2, 3));
    EXPECT_THAT(find(chain, "183")->target.rows, ElementsAre(0, 1, 2, 3));
}

TEST(EditedDrawing, UOfALinkJoinsItsTwoEnds)
{
    DrawingOptions options;
    options.measured = true;
    options.lengths_from = LengthsFrom::Previous;
    SizeUncertainty known;
    known.z_start_um = 30;
    known.z_end_um = 40;
    options.uncertainties.assign(4, known);
    EXPECT_NE(find(drawShaft(table1Part(), options), "75.000 ±0.050"), nullptr);
}

TEST(EditedDrawing, ARowWhoseMeasuredValuesStandIsDrawnAsMeasured)
{
    Shaft shaft = table1Part();
    SizeUncertainty known;
    known.start_diameter_um = 4;
    known.z_start_um = 6;
    known.z_end_um = 8;
    for (ShaftSegment& row : shaft.segments)
        row.measured = MeasuredSize{row.length_mm, row.start_diameter_mm, row.end_diameter_mm, {}, known};
    shaft.segments[1].start_diameter_mm = shaft.segments[1].end_diameter_mm = 36;  // a nominal one was set
    const Drawing drawing = drawShaft(shaft, {});
    const Label* const diameter = find(drawing, "⌀30.000 ±0.004");
    ASSERT_NE(diameter, nullptr);
    EXPECT_TRUE(diameter->italic);
    ASSERT_NE(find(drawing, "⌀36 [1]"), nullptr);
    EXPECT_FALSE(find(drawing, "⌀36 [1]")->italic);
    EXPECT_NE(find(drawing, "98.000 ±0.010"), nullptr);
    EXPECT_NE(find(drawing, "italic: as measured; not a specification. ± U: k = 2; no ±: U is not known"), nullptr);
}

TEST(EditedDrawing, ChainsCanBeReadOnEverySheet)
{
    for (const auto& [name, shaft] : allParts())
        for (const std::optional<Sheet> sheet : {std::optional<Sheet>(), std::optional(Sheet::A4Landscape),
                                                 std::optional(Sheet::A4Portrait), std::optional(Sheet::A3Landscape)}) {
            SCOPED_TRACE(name + (sheet ? std::to_string(static_cast<int>(*sheet)) : ""));
            DrawingOptions options;
            options.sheet = sheet;
            options.lengths_from = LengthsFrom::Previous;
            const Drawing drawing = drawShaft(shaft, options);
            EXPECT_TRUE(drawing.complete);
            EXPECT_THAT(overlappingTexts(drawing), IsEmpty());
            EXPECT_THAT(crossedTexts(drawing), IsEmpty());
            EXPECT_TRUE(frameBox(drawing.sheet).contains(boxOf(drawing)));
        }
}

TEST(EditedDrawing, EveryTextSaysWhichRowsItIsOf)
{
    const Shaft shaft = undercutPart();
    const Drawing drawing = drawShaft(shaft, {});
    using Of = DimensionTarget::Of;
    const Label* const end = find(drawing, "1×45°");
    ASSERT_NE(end, nullptr);
    EXPECT_EQ(end->target, (DimensionTarget{Of::Chamfer, {0}}));
    EXPECT_EQ(find(drawing, "⌀20")->target, (DimensionTarget{Of::Diameter, {1, 3}}));  // the groove parts it
    EXPECT_EQ(find(drawing, "1.3×⌀19")->target, (DimensionTarget{Of::Groove, {2}}));
    EXPECT_EQ(find(drawing, "DIN 509 - E 0.6×0.2")->target, (DimensionTarget{Of::Groove, {4, 5, 6}}));
    EXPECT_EQ(find(drawing, "R1")->target, (DimensionTarget{Of::ArcRadius, {15}}));
    EXPECT_EQ(find(drawShaft(taperPart(), {}), "▷1:10 (40)")->target, (DimensionTarget{Of::Taper, {4}}));
    for (const Label& label : drawing.labels)
        if (label.layer != Layer::Dimensions) {
            EXPECT_EQ(label.target.of, Of::None);
        }
}

TEST(EditedDrawing, TheOriginIsTheFreeEndOnTheAxis)
{
    const Drawing drawing = drawShaft(table1Part(), {});
    double left = 1e9;
    for (const Line& line : drawing.lines)
        if (line.layer == Layer::Contour) left = std::min(left, line.from_mm.x());
    EXPECT_NEAR(drawing.origin_mm.x(), left, 1e-9);
    for (const Line& line : drawing.lines)
        if (line.layer == Layer::Axis) {
            EXPECT_NEAR(line.from_mm.y(), drawing.origin_mm.y(), 1e-9);
        }
}

TEST(Lanes, NarrowLinksGiveWay)
{
    // Two narrow ones whose texts stand left of them, between wide ones; then the whole.
    const std::vector<LaneSpan> spans{
        {0, 40, 0, 40}, {40, 44, 28, 49}, {44, 48, 32, 53}, {48, 90, 48, 90}, {0, 90, 0, 90}};
    const std::vector<int> lanes = lanesOf(spans);
    EXPECT_THAT(lanes, ElementsAre(0, 1, 2, 0, 3));
    EXPECT_THAT(lanesOf({}), IsEmpty());
}

TEST(Lanes, NoTwoOnOneLaneOverlap)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> wide(2, 30), text(5, 20);
    for (int run = 0; run < 200; ++run) {
        std::vector<LaneSpan> spans;
        double x = 0;
        for (int i = 0; i < 12; ++i) {
            const double to = x + wide(random), room = text(random);
            spans.push_back({x, to, room < to - x ? x : x - room, to});
            x = to;
        }
        const std::vector<int> lanes = lanesOf(spans);
        for (std::size_t i = 0; i < spans.size(); ++i)
            for (std::size_t j = i + 1; j < spans.size(); ++j) {
                if (lanes[i] == lanes[j]) {
                    EXPECT_TRUE(spans[i].right_mm <= spans[j].left_mm + 1e-6);
                }
                for (const double down : {spans[i].from_mm, spans[i].to_mm})  // crosses the lanes nearer to the view
                    if (lanes[j] < lanes[i]) {
                        EXPECT_FALSE(down > spans[j].left_mm && down < spans[j].from_mm - 1e-6);
                    }
            }
    }
}

}  // namespace
}  // namespace lathelier::drawing
