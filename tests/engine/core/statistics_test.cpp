#include "engine/core/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lathelier {
namespace {

TEST(Statistics, MedianAndQuantiles)
{
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_TRUE(std::isnan(median({})));
    std::vector<double> values{4, 1, 2, 3};
    EXPECT_EQ(upperMedianInPlace(values), 3);
    EXPECT_EQ(quantileInPlace(values, 0), 1);
    EXPECT_EQ(quantileInPlace(values, 1), 4);
}

}  // namespace
}  // namespace lathelier
