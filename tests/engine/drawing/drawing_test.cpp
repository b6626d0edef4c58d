// Boxes, widths, scales, leaders, hatching: the parts of a drawing by themselves.
#include "engine/drawing/drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/drawing/dimension_texts.h"
#include "engine/drawing/leaders.h"
#include "engine/drawing/view.h"

namespace lathelier::drawing {
namespace {

TEST(Drawing, ScalesFallByHalfOrMore)
{
    for (std::size_t i = 1; i < scales().size(); ++i)
        EXPECT_LE(scales()[i].factor(), 0.5 * scales()[i - 1].factor() + 1e-12);
    EXPECT_EQ((Scale{1, 5}.text()), "1:5");
}

TEST(Drawing, WidthsAreThoseOfTheFont)
{
    EXPECT_NEAR(textWidth_mm("0", 0.729), 0.636, 1e-12);
    EXPECT_NEAR(textWidth_mm("±", 0.729), 0.838, 1e-12);
    EXPECT_EQ(textWidth_mm("", 3.5), 0);
    EXPECT_GT(textWidth_mm("\xff", 3.5), 0);  // no UTF-8
}

TEST(Drawing, BoxesOfTextsTurnAndKeepTheirAnchor)
{
    Label label{{10, 20}, 3.5};
    label.text = "125";
    const Box level = boxOf(label);
    EXPECT_NEAR(level.left_mm, 10, 1e-12);
    EXPECT_LT(level.bottom_mm, 20);
    EXPECT_GT(level.top_mm, 23.5);
    label.anchor = Anchor::End;
    EXPECT_NEAR(boxOf(label).right_mm, 10, 1e-12);
    label.angle_deg = 90;
    const Box upright = boxOf(label);
    EXPECT_NEAR(upright.height_mm(), level.width_mm(), 1e-9);
    EXPECT_NEAR(upright.top_mm, 20, 1e-9);
    EXPECT_LT(upright.left_mm, 10 - 3.5);
}

TEST(Drawing, NumbersAreShortAndTakeTheSeparator)
{
    EXPECT_EQ(shortNumber(30, 3, "."), "30");
    EXPECT_EQ(shortNumber(33.8, 3, ","), "33,8");
    EXPECT_EQ(shortNumber(-0.0001, 3, "."), "0");
    EXPECT_EQ(roundedNumber(1.1471, "."), "1.15");
    EXPECT_EQ(roundedNumber(12345, "."), "12300");
    EXPECT_EQ(roundedNumber(0.04567, ","), "0,0457");
    EXPECT_EQ(nominalSize(30, SizeTolerance{"h6", {}, {}}, "."), "30 h6");
    EXPECT_EQ(nominalSize(30, SizeTolerance{"", -10., 10.}, "."), "30 ±0.01");
    EXPECT_EQ(nominalSize(30, SizeTolerance{"", -21., 0.}, "."), "30 0/\u22120.021");
    EXPECT_EQ(measuredSize(29.9984, 4.2, "."), "29.998 ±0.004");
    EXPECT_EQ(measuredSize(29.9984, 0.1, "."), "29.998 ±0.001");
    EXPECT_EQ(measuredSize(29.9984, 230., ","), "30,00 ±0,23");
    EXPECT_EQ(measuredSize(29.9984, std::nullopt, "."), "29.998");
}

TEST(Drawing, ThreadsAreNamed)
{
    ShaftMark mark;
    mark.kind = MarkKind::Thread;
    EXPECT_EQ(threadDesignation(mark, "."), "");
    mark.major_mm = 20;
    mark.pitch_mm = 2;
    EXPECT_EQ(threadDesignation(mark, "."), "M20×2");
    mark.starts = 2;
    mark.hand = -1;
    EXPECT_EQ(threadDesignation(mark, "."), "M20×4 (P2) LH");
    mark.designation = "Tr20×4";
    EXPECT_EQ(threadDesignation(mark, "."), "Tr20×4");
}

TEST(Leaders, NeverCrossAndKeepTheirDistance)
{
    std::mt19937 random(7);
    const auto uniform = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
    for (int run = 0; run < 200; ++run) {
        std::vector<LeaderText> texts(1 + random() % 14);
        for (LeaderText& text : texts) text = {uniform(150), 5 + uniform(40)};
        const std::vector<LeaderPlace> places = placeLeaders(texts, 2);
        ASSERT_EQ(places.size(), texts.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            for (std::size_t j = 0; j < places.size(); ++j) {
                if (i == j) continue;
                EXPECT_GE(std::abs(places[i].x_mm - places[j].x_mm), 2 - 1e-9);
                if (texts[i].x_mm < texts[j].x_mm) {
                    EXPECT_LT(places[i].x_mm, places[j].x_mm);
                }
                // The leader of j passes every lane up to its own.
                const double left = places[i].x_mm - (places[i].to_left ? texts[i].width_mm : 0);
                const bool under = places[j].x_mm > left && places[j].x_mm < left + texts[i].width_mm;
                if (under) {
                    EXPECT_LT(places[j].lane, places[i].lane);
                }
            }
    }
}

TEST(Leaders, StandAtTheirPlacesWhereThereIsRoom)
{
    const std::vector<LeaderPlace> places = placeLeaders({{50, 10}, {10, 10}}, 2);
    EXPECT_EQ(places[0].x_mm, 50);
    EXPECT_EQ(places[1].x_mm, 10);
    EXPECT_EQ(places[0].lane + places[1].lane, 0);
}

TEST(Hatch, FillsASquareWithAHole)
{
    const Polygon square = {{0, 0}, {40, 0}, {40, 40}, {0, 40}}, hole = {{10, 10}, {10, 30}, {30, 30}, {30, 10}};
    double length = 0;
    for (const Line& line : hatch({square, hole}, 0.5)) {
        EXPECT_EQ(line.layer, Layer::Hatch);
        const Eigen::Vector2d middle = (line.from_mm + line.to_mm) / 2, off = (middle.array() - 20).abs();
        EXPECT_TRUE(off.maxCoeff() < 20 && off.maxCoeff() > 10);
        length += (line.to_mm - line.from_mm).norm();
    }
    EXPECT_NEAR(length * 0.5, 1200, 12);  // area over spacing
    EXPECT_TRUE(hatch({}, 2).empty());
}

}  // namespace
}  // namespace lathelier::drawing
