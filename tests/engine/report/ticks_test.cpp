#include "engine/report/ticks.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace lathelier {
namespace {

TEST(Ticks, ReadableSteps)
{
    EXPECT_EQ(niceTicks(0, 183, 10).values, (std::vector<double>{0, 20, 40, 60, 80, 100, 120, 140, 160, 180}));
    const Ticks small = niceTicks(-0.3, 0.3, 6);
    EXPECT_EQ(small.values.size(), 7u);
    EXPECT_EQ(small.decimals, 1);
    EXPECT_EQ(tickLabel(small.values[3], small, {}), "0.0");
    EXPECT_EQ(niceTicks(0, 1, 4).decimals, 1);
    EXPECT_EQ(niceTicks(0, 0.001, 2).decimals, 4);
}

TEST(Ticks, LabelsTellNeighboursApartAndStayInside)
{
    rc::check([](int mantissa, int power) {
        const double from = mantissa * std::pow(10.0, power % 9);
        const double width = (1 + std::abs(mantissa % 97)) * std::pow(10.0, power % 7);
        RC_PRE(std::abs(from) < 1e6 * width);
        const Ticks ticks = niceTicks(from, from + width, 8);
        RC_ASSERT(ticks.values.size() >= 3u && ticks.values.size() <= 20u);
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
            RC_ASSERT(ticks.values[i] >= from - 1e-6 * width && ticks.values[i] <= from + width * (1 + 1e-6));
            if (i > 0 && std::abs(ticks.values[i]) < 1e7)
                RC_ASSERT(tickLabel(ticks.values[i], ticks, {}) != tickLabel(ticks.values[i - 1], ticks, {}));
        }
    });
}

}  // namespace
}  // namespace lathelier
