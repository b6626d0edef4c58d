// Columns of stock, convex polygons and outlines against closed forms.
#include "engine/stock/meridian_stock.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../core/code_of_error.h"
#include "engine/stock/stock_codes.h"
#include "engine/stock/stock_outline.h"
#include "made_program.h"

namespace lathelier::stock {
namespace {

using std::numbers::pi;

ConvexPolygon box(double z0, double z1, double x0, double x1)
{
    return {{z0, x0}, {z1, x0}, {z1, x1}, {z0, x1}};
}

double areaOf(const ConvexPolygon& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.z_mm * b.x_mm - a.x_mm * b.z_mm;
    }
    return twice / 2;
}

TEST(MeridianStock, VolumesOfABarATubeAndACone)
{
    EXPECT_NEAR(MeridianStock(bar(50, 30), 0.02).volume_mm3(), pi * 15 * 15 * 50, 1e-8);
    EXPECT_NEAR(MeridianStock(bar(50, 30, 10), 0.02).volume_mm3(), pi * (15 * 15 - 5 * 5) * 50, 1e-8);
    Shaft cone;
    cone.segments = {{30, 20, 40, 0, {}, {}}};
    EXPECT_NEAR(MeridianStock(cone, 0.02).volume_mm3(), pi / 3 * 30 * (100 + 200 + 400), 0.01);
    Shaft ball;
    ball.segments = {{10, 0, 20, 0, 10.0, {}}};
    EXPECT_NEAR(MeridianStock(ball, 0.02).volume_mm3(), 2 * pi / 3 * 1000, 0.01);
}

TEST(MeridianStock, ColumnsFillTheLengthAndStayBounded)
{
    const MeridianStock small(bar(10.01, 30), 0.02);
    EXPECT_NEAR(small.length_mm(), 10.01, 1e-12);
    EXPECT_LE(small.step_mm(), 0.02);
    const MeridianStock large(bar(5000, 30), 0.02);
    EXPECT_EQ(large.columns(), mostColumns);
    EXPECT_DOUBLE_EQ(large.step_mm(), 0.25);
}

TEST(MeridianStock, RefusesWhatIsNoStock)
{
    EXPECT_EQ(codeOfError([] { MeridianStock(Shaft(), 0.02); }), errors::stockWithoutLength);
    EXPECT_EQ(codeOfError([] { MeridianStock(bar(-1, 10), 0.02); }), errors::stockSegmentImpossible);
    EXPECT_EQ(codeOfError([] { MeridianStock(bar(10, std::nan("")), 0.02); }), errors::stockSegmentImpossible);
    EXPECT_FALSE(MeridianStock(bar(10, 10, 12), 0.02).outerRadius_mm(5));
}

TEST(MeridianStock, AWindowInAColumnIsTakenOffExactly)
{
    MeridianStock stock(bar(20, 30), 0.02);
    const Removal removal = stock.remove(box(5, 10, 4, 8));
    EXPECT_NEAR(removal.area_mm2, 20, 1e-9);
    EXPECT_NEAR(removal.volume_mm3, pi * (64 - 16) * 5, 1e-8);
    const std::vector<RadialSpan> spans = stock.spans(350);  // z = 7
    ASSERT_EQ(spans.size(), 2U);
    EXPECT_EQ(spans[0], (RadialSpan{0, 4}));
    EXPECT_EQ(spans[1], (RadialSpan{8, 15}));
    EXPECT_EQ(stock.outerRadius_mm(7), 15);
    EXPECT_EQ(stock.innerRadius_mm(7), 0);
    EXPECT_NEAR(stock.remove(box(5, 10, 0, 20)).area_mm2, 5 * 11, 1e-9);
    EXPECT_FALSE(stock.outerRadius_mm(7));
    EXPECT_EQ(stock.remove(box(5, 10, 0, 20)).area_mm2, 0);
}

TEST(MeridianStock, OverlapIsLocated)
{
    const MeridianStock stock(bar(20, 30), 0.02);
    const StockOverlap met = stock.overlap(box(5, 7, 14, 40));
    EXPECT_NEAR(met.depth_mm, 1, 1e-12);
    EXPECT_NEAR(met.width_mm, 2, 1e-9);
    EXPECT_NEAR(met.z_mm, 5.01, 1e-9);
    EXPECT_NEAR(met.x_mm, 14, 1e-12);
    EXPECT_FALSE(stock.overlap(box(5, 7, 15, 40)).isThere());
    EXPECT_FALSE(stock.overlap(box(-5, 0, 1, 40)).isThere());
    EXPECT_FALSE(stock.overlap(box(20, 30, 1, 40)).isThere());
    EXPECT_FALSE(stock.overlap(box(5, 7, 14, 40), 1.5).isThere());
    EXPECT_FALSE(stock.overlap({}).isThere());
}

TEST(ConvexPolygon, ASweepIsTheHullOfBothPlacements)
{
    const ConvexPolygon shape = hullOf({{0, 0}, {2, 0}, {3, 1}, {1, 3}, {1, 1}});
    ASSERT_EQ(shape.size(), 4U);
    for (const Corner by : {Corner{5, 0}, Corner{0, -4}, Corner{-3, 2}, Corner{1, 1}, Corner{0, 0}}) {
        ConvexPolygon corners = shape, moved = movedBy(shape, by);
        corners.insert(corners.end(), moved.begin(), moved.end());
        EXPECT_NEAR(areaOf(sweptBy(shape, by)), areaOf(hullOf(corners)), 1e-12);
    }
}

TEST(ConvexPolygon, GrowsShrinksAndMeets)
{
    const ConvexPolygon square = box(0, 10, 0, 10);
    EXPECT_NEAR(areaOf(shrunkBy(square, 1)), 64, 1e-12);
    EXPECT_TRUE(shrunkBy(square, 6).empty());
    const Box grown = boxOf(grownBy(square, 1));
    EXPECT_NEAR(grown.low.z_mm, -1, 1e-12);
    EXPECT_NEAR(grown.high.x_mm, 11, 1e-12);
    EXPECT_NEAR(areaOf(grownBy(square, 1)), 100 + 40 + 8 * std::tan(pi / 8), 1e-9);
    EXPECT_NEAR(areaOf(overlapOf(square, box(8, 20, -5, 4))), 8, 1e-12);
    EXPECT_TRUE(overlapOf(square, box(10.5, 20, 0, 4)).empty());
}

ConvexPolygon someTriangle(std::mt19937& random)
{
    std::uniform_real_distribution<double> z(-5, 45), x(-2, 22);
    for (;;) {
        ConvexPolygon shape = hullOf({{z(random), x(random)}, {z(random), x(random)}, {z(random), x(random)}});
        if (!shape.empty()) return shape;
    }
}

RC_GTEST_PROP(MeridianStockProperty, WhatIsTakenOffIsMissing, (unsigned seed))
{
    std::mt19937 random(seed);
    MeridianStock stock(bar(40, 36, 6), 0.05);
    const double area = stock.area_mm2(), volume = stock.volume_mm3();
    Removal sum;
    for (int i = 0; i < 20; ++i) {
        const ConvexPolygon shape = someTriangle(random);
        const Removal one = stock.remove(shape);
        RC_ASSERT(one.area_mm2 >= 0);
        RC_ASSERT(one.area_mm2 <= areaOf(shape) + 0.05 * 24);
        RC_ASSERT(!stock.overlap(shape, 1e-8).isThere());
        sum.area_mm2 += one.area_mm2;
        sum.volume_mm3 += one.volume_mm3;
    }
    RC_ASSERT(std::abs(stock.area_mm2() + sum.area_mm2 - area) < 1e-8);
    RC_ASSERT(std::abs(stock.volume_mm3() + sum.volume_mm3 - volume) < 1e-6);
}

RC_GTEST_PROP(MeridianStockProperty, TheOrderOfCutsDoesNotMatter, (unsigned seed))
{
    std::mt19937 random(seed);
    std::vector<ConvexPolygon> cuts;
    for (int i = 0; i < 12; ++i) cuts.push_back(someTriangle(random));
    MeridianStock one(bar(40, 36), 0.05), other(bar(40, 36), 0.05);
    for (const ConvexPolygon& cut : cuts) one.remove(cut);
    for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) other.remove(*cut);
    RC_ASSERT(std::abs(one.area_mm2() - other.area_mm2()) < 1e-8);
    for (std::size_t i = 0; i < one.columns(); ++i) {
        const auto a = one.spans(i), b = other.spans(i);
        RC_ASSERT(a.size() == b.size());
        for (std::size_t k = 0; k < a.size(); ++k) RC_ASSERT(std::abs(a[k].high_mm - b[k].high_mm) < 1e-8);
    }
}

/// Shoelace over all closed polylines: cavities count negative, as material is on the left.
double areaOf(const StockOutline& outline)
{
    double twice = 0;
    for (std::size_t i = 1; i < outline.z_mm.size(); ++i) {
        const double part = outline.z_mm[i - 1] * outline.x_mm[i] - outline.x_mm[i - 1] * outline.z_mm[i];
        if (!std::isnan(part)) twice += part;
    }
    return twice / 2;
}

RC_GTEST_PROP(StockOutlineProperty, OutlinesCloseAndEncloseTheMaterial, (unsigned seed))
{
    std::mt19937 random(seed);
    MeridianStock stock(bar(40, 36, 6), 0.05);
    for (int i = 0; i < 10; ++i) stock.remove(someTriangle(random));
    const StockOutline outline = outlineOf(stock, 0);
    // Between the middles of columns the outline runs straight, where the columns have steps.
    RC_ASSERT(std::abs(areaOf(outline) - stock.area_mm2()) < 40 * 0.05 * 2);
    bool starts = true;
    Corner first;
    for (std::size_t i = 0; i < outline.z_mm.size(); ++i) {
        if (starts) first = {outline.z_mm[i], outline.x_mm[i]};
        starts = std::isnan(outline.z_mm[i]);
        if (starts || i + 1 == outline.z_mm.size()) {
            const std::size_t last = starts ? i - 1 : i;
            RC_ASSERT(outline.z_mm[last] == first.z_mm && outline.x_mm[last] == first.x_mm);
        }
    }
}

TEST(StockOutline, ABarIsARectangle)
{
    const StockOutline outline = outlineOf(MeridianStock(bar(20, 30), 0.02), 0.005);
    EXPECT_LE(outline.z_mm.size(), 7U);
    EXPECT_NEAR(areaOf(outline), 300, 1e-9);
    EXPECT_TRUE(outlineOf(MeridianStock(), 0.005).z_mm.empty());
}

TEST(StockOutline, APartedBarHasTwoOutlinesAndAWindowItsOwn)
{
    MeridianStock stock(bar(20, 30), 0.02);
    stock.remove(box(9, 12, 0, 20));
    stock.remove(box(2, 4, 5, 6));
    const StockOutline outline = outlineOf(stock, 0.005);
    EXPECT_EQ(std::count_if(outline.z_mm.begin(), outline.z_mm.end(), [](double z) { return std::isnan(z); }), 2);
    EXPECT_NEAR(areaOf(outline), 20 * 15 - 3 * 15 - 2, 0.02);
}

}  // namespace
}  // namespace lathelier::stock
