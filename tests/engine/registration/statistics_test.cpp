#include "engine/registration/statistics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lathelier::registration {
namespace {

RC_GTEST_PROP(Statistics, QuantilesAreOrderStatistics, (std::vector<int> numbers))
{
    RC_PRE(!numbers.empty());
    std::vector<float> values(numbers.begin(), numbers.end());
    const std::vector<double> found = quantiles(values, {0, 0.025, 0.5, 0.975, 1});
    std::sort(values.begin(), values.end());
    const double shares[] = {0, 0.025, 0.5, 0.975, 1};
    for (std::size_t k = 0; k < 5; ++k) {
        const auto rank =
            std::min(values.size() - 1, static_cast<std::size_t>(shares[k] * static_cast<double>(values.size())));
        RC_ASSERT(found[k] == static_cast<double>(values[rank]));
    }
}

RC_GTEST_PROP(Statistics, EveryValueIsInOneBinOfTheHistogram, (std::vector<int> numbers))
{
    RC_PRE(!numbers.empty());
    std::vector<float> values;
    for (const int n : numbers) values.push_back(static_cast<float>(n) * 1e-3f);
    const Histogram histogram = histogramOf(values);
    RC_ASSERT(histogram.edges_mm.size() == histogram.counts.size() + 1);
    RC_ASSERT(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::int64_t{0}) ==
              static_cast<std::int64_t>(values.size()));
    RC_ASSERT(histogram.counts.size() <= 501u);
    const double width = histogram.edges_mm[1] - histogram.edges_mm[0];
    RC_ASSERT(histogram.edges_mm.front() <= *std::min_element(values.begin(), values.end()) + 1e-3 * width);
    RC_ASSERT(histogram.edges_mm.back() >= *std::max_element(values.begin(), values.end()) - 1e-3 * width);
}

TEST(Statistics, TheBinOfASingleLargeValueHoldsIt)
{
    const std::vector<float> values{29205.891f};
    const Histogram histogram = histogramOf(values);
    ASSERT_EQ(histogram.counts, std::vector<std::int64_t>{1});
    EXPECT_LE(histogram.edges_mm.front(), values[0]);
    EXPECT_GE(histogram.edges_mm.back(), values[0]);
}

TEST(Statistics, OfKnownValues)
{
    std::vector<float> values;
    for (int i = -50; i <= 50; ++i) values.push_back(static_cast<float>(i) * 0.01f);
    const DeviationStatistics s = summarise(values);
    EXPECT_EQ(s.points_used, 101);
    EXPECT_NEAR(s.mean_mm, 0, 1e-8);
    EXPECT_NEAR(s.std_mm, 0.01 * std::sqrt((101.0 * 101 - 1) / 12), 1e-8);
    EXPECT_NEAR(s.rmse_mm, s.std_mm, 1e-8);
    EXPECT_NEAR(s.min_mm, -0.5, 1e-7);
    EXPECT_NEAR(s.max_mm, 0.5, 1e-7);
    EXPECT_NEAR(s.median_mm, 0, 1e-8);
    EXPECT_NEAR(s.mad_sigma_mm, 1.4826 * 0.25, 1e-6);
    EXPECT_NEAR(s.p95_abs_mm, 0.48, 1e-6);
    EXPECT_TRUE(std::isnan(summarise({}).mean_mm));
    EXPECT_TRUE(histogramOf({}).counts.empty());
}

}  // namespace
}  // namespace lathelier::registration
