#include "engine/registration/verdict/verdict.h"
#include "engine/registration/registration_codes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lathelier::registration {
namespace {

/// Deviations 0.00, 0.01, … 0.99 with alternating sign; the last ten do not count.
CompareResult ladder()
{
    CompareResult result;
    for (int i = 0; i < 100; ++i) {
        result.deviation_mm.push_back(static_cast<float>((i % 2 ? -0.01 : 0.01) * i));
        result.used.push_back(i < 90);
    }
    result.statistics.points_used = 90;
    result.statistics.points_excluded = 10;
    result.statistics.rmse_mm = 0.5;
    return result;
}

TEST(Verdict, CountsTheShareOfUsedPointsOnBothSides)
{
    CompareResult result = ladder();
    CompareParameters parameters;
    parameters.verdict_rule = VerdictRule::Points;
    parameters.tolerance_mm = 0.4451;
    judge(result, parameters);
    EXPECT_DOUBLE_EQ(*result.within_tolerance_percent, 50);
    EXPECT_EQ(result.verdict, Verdict::Fail);
    parameters.pass_percent = 50;
    judge(result, parameters);
    EXPECT_EQ(result.verdict, Verdict::Pass);
    EXPECT_EQ(result.parameters.pass_percent, 50);
    parameters.tolerance_mm = 10;
    judge(result, parameters);
    EXPECT_DOUBLE_EQ(*result.within_tolerance_percent, 100);
}

TEST(Verdict, IsNoneWithoutATolerance)
{
    CompareResult result = ladder();
    CompareParameters parameters;
    parameters.verdict_rule = VerdictRule::Points;
    parameters.tolerance_mm = 0.5;
    judge(result, parameters);
    ASSERT_TRUE(result.verdict);
    judge(result, {});
    EXPECT_FALSE(result.verdict);
    EXPECT_FALSE(result.within_tolerance_percent);
    EXPECT_FALSE(result.parameters.tolerance_mm);
}

TEST(Verdict, SaysOnceThatTheScannerCannotTell)
{
    CompareResult result = ladder();
    CompareParameters parameters;
    parameters.scanner_accuracy_mm = 0.5;
    judge(result, parameters);
    judge(result, parameters);
    EXPECT_EQ(result.distinguishable_from_scanner, false);
    EXPECT_EQ(result.notes.size(), 1U);
    EXPECT_TRUE(contains(result.notes, notes::notDistinguishable));
    parameters.scanner_accuracy_mm = 0.4;
    judge(result, parameters);
    EXPECT_EQ(result.distinguishable_from_scanner, true);
    EXPECT_TRUE(result.notes.empty());
}

TEST(Verdict, KnowsWhichParametersAskForANewRegistration)
{
    const CompareParameters plain;
    CompareParameters other;
    other.tolerance_mm = 0.1;
    other.pass_percent = 90;
    other.scanner_accuracy_mm = 0.05;
    other.verdict_rule = VerdictRule::Points;
    other.decision = DecisionRule::Guarded;
    other.zones = {{"a", 1, 2, {}, {}}};
    EXPECT_TRUE(sameButVerdict(plain, other));
    other.max_distance_mm = 2;
    EXPECT_FALSE(sameButVerdict(plain, other));
    other = plain;
    other.exclude_z_mm = {{0, 10}};
    EXPECT_FALSE(sameButVerdict(plain, other));
    other = plain;
    other.method = CompareMethod::Point;
    EXPECT_FALSE(sameButVerdict(plain, other));
}

}  // namespace
}  // namespace lathelier::registration
