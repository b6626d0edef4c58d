#include "engine/signal/hampel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "engine/core/random.h"
#include "engine/core/statistics.h"

namespace lathelier::signal {
namespace {

TEST(Hampel, FindsPeaksAndPitsOnAWavyRecordAndNothingElse)
{
    std::vector<double> values;
    for (int i = 0; i < 400; ++i)
        values.push_back(50 * std::cos(2 * std::numbers::pi * i / 400) + 3 * std::cos(10 * std::numbers::pi * i / 400) +
                         .8 * randomNormal(1, 0, static_cast<std::uint64_t>(i)));
    const std::vector<std::uint8_t> none = hampelOutliers(values);
    EXPECT_EQ(std::accumulate(none.begin(), none.end(), 0), 0);
    values[0] += 30;
    values[151] -= 25;
    values[152] -= 25;
    const std::vector<std::uint8_t> found = hampelOutliers(values);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(found[i], i == 0 || i == 151 || i == 152) << i;
}

TEST(Hampel, TakesFewHonestValuesOfALongRecord)
{
    std::vector<double> values(100000);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = randomNormal(3, 0, i);
    const std::vector<std::uint8_t> found = hampelOutliers(values);
    EXPECT_LE(std::accumulate(found.begin(), found.end(), 0), 20);
}

TEST(Hampel, AgainstOneMedian)
{
    const std::vector<double> periods{61.5, 61.6, 61.4, 61.5, 123, 61.5, 61.6};
    const std::vector<std::uint8_t> expected{0, 0, 0, 0, 1, 0, 0};
    EXPECT_EQ(hampelOutliers(periods, {.half_window = 0}), expected);
}

TEST(Hampel, EqualAndMissingValues)
{
    std::vector<double> values(20, 7.0);
    EXPECT_EQ(hampelOutliers(values), std::vector<std::uint8_t>(20, 0));
    values[4] = std::numeric_limits<double>::quiet_NaN();
    values[9] = 7.001;
    std::vector<std::uint8_t> expected(20, 0);
    expected[4] = expected[9] = 1;
    EXPECT_EQ(hampelOutliers(values), expected);
    expected[9] = 0;
    EXPECT_EQ(hampelOutliers(values, {.least_spread = .001}), expected);
    EXPECT_TRUE(hampelOutliers({}).empty());
}

/// The definition itself, window by window.
std::vector<std::uint8_t> byDefinition(const std::vector<double>& values, const HampelOptions& options)
{
    const auto n = static_cast<int>(values.size());
    std::vector<double> distance(values.size(), std::numeric_limits<double>::infinity()), spread(values.size()), all;
    for (int i = 0; i < n; ++i) {
        std::vector<double> window;
        for (int j = i - options.half_window; j <= i + options.half_window; ++j)
            if (options.closed || (j >= 0 && j < n))
                if (const double value = values[static_cast<std::size_t>((j + n) % n)]; std::isfinite(value))
                    window.push_back(value);
        const auto at = static_cast<std::size_t>(i);
        if (!std::isfinite(values[at])) continue;
        spread[at] = robustSpread(window);
        distance[at] = std::abs(values[at] - median(window));
        all.push_back(distance[at]);
    }
    const double overall = 1.4826 * median(all);
    std::vector<std::uint8_t> result;
    for (std::size_t i = 0; i < values.size(); ++i)
        result.push_back(distance[i] > options.threshold * std::max(spread[i], overall));
    return result;
}

TEST(Hampel, IsTheDefinitionForClosedAndOpenRecordsWithHoles)
{
    std::vector<double> values(20000);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = std::round(4 * randomNormal(9, 0, i)) / 4;  // with equal values
        if (randomUniform(9, 1, i) < 0.2) values[i] = std::numeric_limits<double>::quiet_NaN();
    }
    for (const int half : {1, 2, 5})
        for (const bool closed : {true, false}) {
            const HampelOptions options{.half_window = half, .threshold = 2, .closed = closed};
            const std::vector<std::uint8_t> found = hampelOutliers(values, options);
            EXPECT_GT(std::accumulate(found.begin(), found.end(), 0), 4000);  // the missing ones at least
            EXPECT_EQ(found, byDefinition(values, options)) << half << closed;
        }
}

TEST(RobustSpread, IsThatOfNormalValues)
{
    EXPECT_NEAR(robustSpread({1, 2, 3, 4, 5}), 1.4826, 1e-12);
}

}  // namespace
}  // namespace lathelier::signal
