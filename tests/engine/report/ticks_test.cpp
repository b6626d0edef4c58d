#include "engine/report/ticks.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace lathelier {
namespace {

TEST(Ticks, ReadableSteps)
{
    EXPECT_EQ(report::niceTicks(0, 183, 10).values, (std::vector<double>{0, 20, 40, 60, 80, 100, 120, 140, 160, 180}));
    const report::Ticks small = report::niceTicks(-0.3, 0.3, 6);
    EXPECT_EQ(small.values.size(), 7u);
    EXPECT_EQ(small.decimals, 1);
    EXPECT_EQ(report::tickLabel(small.values[3], small, {}), "0.0");
    EXPECT_EQ(report::niceTicks(0, 1, 4).decimals, 1);
    EXPECT_EQ(report::niceTicks(0, 0.001, 2).decimals, 4);
}

TEST(Ticks, LabelsTellNeighboursApartAndStayInside)
{
    rc::check([](int mantissa, int power) {
        const double from = mantissa * std::pow(10.0, power % 9);
        const double width = (1 + std::abs(mantissa % 97)) * std::pow(10.0, power % 7);
        RC_PRE(std::abs(from) < 1e6 * width);
        const report::Ticks ticks = report::niceTicks(from, from + width, 8);
        RC_ASSERT(ticks.values.size() >= 3u && ticks.values.size() <= 20u);
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
            RC_ASSERT(ticks.values[i] >= from - 1e-6 * width && ticks.values[i] <= from + width * (1 + 1e-6));
            if (i > 0 && std::abs(ticks.values[i]) < 1e7)
                RC_ASSERT(report::tickLabel(ticks.values[i], ticks, {}) !=
                          report::tickLabel(ticks.values[i - 1], ticks, {}));
        }
    });
}

std::vector<std::string> labels(const report::Ticks& ticks)
{
    std::vector<std::string> result;
    for (const double value : ticks.values) result.push_back(report::tickLabel(value, ticks, {}));
    return result;
}

TEST(Ticks, LogarithmicAxesShowOneTwoFive)
{
    const report::Ticks ticks = report::logTicks(0.15, 22, 8);
    EXPECT_EQ(labels(ticks), (std::vector<std::string>{"0.2", "0.5", "1", "2", "5", "10", "20"}));
    EXPECT_EQ(ticks.minor.size(), 12u);  // 0.3 0.4 0.6 … 0.9, 3 4 6 … 9
    EXPECT_NEAR(ticks.minor.front(), 0.3, 1e-12);
}

TEST(Ticks, LogarithmicAxesOfManyDecadesShowPowersOfTen)
{
    const report::Ticks ticks = report::logTicks(1e-3, 1e3, 8);
    EXPECT_EQ(labels(ticks), (std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10", "100", "1000"}));
    EXPECT_EQ(ticks.minor.size(), 48u);
    const report::Ticks many = report::logTicks(1e-10, 1e10, 5);
    EXPECT_EQ(many.values.size(), 5u);
    EXPECT_EQ(many.minor.size(), 16u);  // the other powers
}

TEST(Ticks, NumbersAreReadableInTheUnitThatIsShown)
{
    const report::Ticks inches = report::axisTicks(report::Axis::Scale::Linear, {0, 183}, 8, 1 / 25.4);
    ASSERT_EQ(inches.values.size(), 8u);
    EXPECT_NEAR(inches.values[3], 3 * 25.4, 1e-9);
    EXPECT_EQ(report::tickLabel(inches.values[3], inches, {}), "3");
}

TEST(Ticks, AShortStretchOfALogarithmicAxisHasEvenTicks)
{
    EXPECT_EQ(report::logTicks(100, 200, 5).values, (std::vector<double>{100, 120, 140, 160, 180, 200}));
    EXPECT_EQ(report::axisTicks(report::Axis::Scale::Whole, {0.5, 3.5}, 10).values, (std::vector<double>{1, 2, 3}));
    EXPECT_TRUE(report::axisTicks(report::Axis::Scale::Whole, {0.5, 3.5}, 10).minor.empty());
    EXPECT_EQ(report::axisTicks(report::Axis::Scale::Whole, {0.5, 40.5}, 4).values,
              (std::vector<double>{10, 20, 30, 40}));
    EXPECT_EQ(report::axisTicks(report::Axis::Scale::Logarithmic, {-1, 1}, 4).values,
              report::niceTicks(-1, 1, 4).values);
}

TEST(Ticks, LogarithmicTicksLieInsideAndApart)
{
    rc::check([](int power, unsigned width) {
        const double from = 1.7 * std::pow(10.0, power % 12);
        const double to = from * (1.01 + width % 100000);
        const report::Ticks ticks = report::logTicks(from, to, 6);
        RC_ASSERT(ticks.values.size() >= 1u && ticks.values.size() <= 12u);
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
            RC_ASSERT(ticks.values[i] >= from * (1 - 1e-6) && ticks.values[i] <= to * (1 + 1e-6));
            if (i > 0) RC_ASSERT(ticks.values[i] > ticks.values[i - 1]);  // RC_ASSERT evaluates both sides of ||
        }
    });
}

}  // namespace
}  // namespace lathelier
