#include "engine/registration/default_reach.h"

#include <gtest/gtest.h>

#include "engine/registration/compare.h"
#include "engine/sample/sample.h"
#include "tests/engine/registration/synthetic_pair.h"

namespace lathelier::registration {
namespace {

TEST(DefaultReach, FollowsSizeAndNoise)
{
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 0), 6);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 2), 20);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 10, 0), 100);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 30, 0), 6) << "no surface";
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 0, 1.5), 15);
    EXPECT_DOUBLE_EQ(defaultReach_mm(1000, 0, 50), 20);
}

TEST(DefaultReach, TakesNoNoticeOfSpuriousPoints)
{
    Scan scan = sample::scanBracket(5000, 0, Eigen::Isometry3d::Identity(), 1);
    const double size = robustSize_mm(scan.points_mm);
    for (int i = 0; i < 100; ++i) scan.points_mm.emplace_back(1e4 * i, 0, 0);
    EXPECT_NEAR(robustSize_mm(scan.points_mm), size, 0.05 * size);
}

/// The same parts a hundredfold smaller and larger: everything but the lengths stays.
TEST(DefaultReach, LetsPartsOfAnySizeBeCompared)
{
    const testing_pair::Pair pair = testing_pair::makePair(3, {.angle_step_deg = 9, .spurious_share = 0.02});
    const Scan bracket = sample::scanBracket(8000, 0.05, Eigen::Isometry3d::Identity(), 1);
    const Scan other = sample::scanBracket(4000, 0.05, Eigen::Isometry3d(Eigen::Translation3d(0.4, 0.2, 0.1)), 2);
    const auto scaled = [](Scan scan, double scale) {
        for (auto& p : scan.points_mm) p *= scale;
        return scan;
    };
    const auto expectAlike = [&](const Scan& reference, const Scan& copy, double scale) {
        const CompareResult base = compare(reference, copy);
        const CompareResult result = compare(scaled(reference, scale), scaled(copy, scale));
        EXPECT_NEAR(static_cast<double>(result.statistics.points_used),
                    static_cast<double>(base.statistics.points_used),
                    0.002 * static_cast<double>(copy.points_mm.size()));
        EXPECT_NEAR(result.statistics.rmse_mm, scale * base.statistics.rmse_mm, 0.03 * scale * base.statistics.rmse_mm);
    };
    expectAlike(pair.reference, pair.copy, 0.01);
    expectAlike(bracket, other, 0.01);
    expectAlike(bracket, other, 100);
}

}  // namespace
}  // namespace lathelier::registration
