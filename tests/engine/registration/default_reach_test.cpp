#include "engine/registration/default_reach.h"

#include <gtest/gtest.h>

#include "engine/project/sample.h"
#include "engine/registration/compare.h"
#include "tests/engine/registration/synthetic_pair.h"

namespace lathelier {
namespace {

TEST(DefaultReach, FollowsSizeAndNoise)
{
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 0), 6);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 2), 20);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 10, 0), 100);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 0, 1.5), 15);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 0, 50), 25);
}

TEST(DefaultReach, TakesNoNoticeOfSpuriousPoints)
{
    Scan scan = scanBracket(5000, 0, Eigen::Isometry3d::Identity(), 1);
    const double size = robustSize_mm(scan.points_mm);
    for (int i = 0; i < 100; ++i) scan.points_mm.emplace_back(1e4 * i, 0, 0);
    EXPECT_NEAR(robustSize_mm(scan.points_mm), size, 0.05 * size);
}

/// The same parts a hundredfold smaller and larger: everything but the lengths stays.
TEST(DefaultReach, LetsPartsOfAnySizeBeCompared)
{
    const testing_pair::Pair pair = testing_pair::makePair(3, {.angle_step_deg = 9, .spurious_share = 0.02});
    const Scan bracket = scanBracket(8000, 0.05, Eigen::Isometry3d::Identity(), 1);
    const Scan other = scanBracket(8000, 0.05, Eigen::Isometry3d(Eigen::Translation3d(0.4, 0.2, 0.1)), 2);
    for (const auto& [reference, copy] : {std::pair{&pair.reference, &pair.copy}, {&bracket, &other}}) {
        const CompareResult base = compare(*reference, *copy);
        for (const double scale : {0.01, 100.0}) {
            Scan a = *reference;
            Scan b = *copy;
            for (auto& p : a.points_mm) p *= scale;
            for (auto& p : b.points_mm) p *= scale;
            const CompareResult result = compare(a, b);
            EXPECT_NEAR(static_cast<double>(result.statistics.points_used),
                        static_cast<double>(base.statistics.points_used),
                        0.002 * static_cast<double>(b.points_mm.size()));
            EXPECT_NEAR(result.statistics.rmse_mm, scale * base.statistics.rmse_mm,
                        0.03 * scale * base.statistics.rmse_mm);
        }
    }
}

}  // namespace
}  // namespace lathelier
