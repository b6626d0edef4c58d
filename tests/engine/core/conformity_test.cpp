#include "engine/core/conformity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lathelier {
namespace {

TEST(Conformity, SimpleComparesTheValueAlone)
{
    EXPECT_EQ(judge(10, 5, 10, DecisionRule::Simple), Verdict::Pass);
    EXPECT_EQ(judge(10.01, 5, 10, DecisionRule::Simple), Verdict::Fail);
    EXPECT_EQ(judge(9, std::nan(""), 10, DecisionRule::Simple), Verdict::Pass);
}

TEST(Conformity, GuardedDecidesOutsideTheUncertaintyOnly)
{
    EXPECT_EQ(judge(8, 2, 10, DecisionRule::Guarded), Verdict::Pass);
    EXPECT_EQ(judge(8.1, 2, 10, DecisionRule::Guarded), Verdict::Undecided);
    EXPECT_EQ(judge(12, 2, 10, DecisionRule::Guarded), Verdict::Undecided);
    EXPECT_EQ(judge(12.1, 2, 10, DecisionRule::Guarded), Verdict::Fail);
    EXPECT_EQ(judge(1, std::nan(""), 10, DecisionRule::Guarded), Verdict::Undecided);
}

TEST(Conformity, TheWorstOfSeveralCounts)
{
    EXPECT_EQ(worse(Verdict::Pass, Verdict::Undecided), Verdict::Undecided);
    EXPECT_EQ(worse(Verdict::Undecided, Verdict::Fail), Verdict::Fail);
    EXPECT_EQ(worse(Verdict::Pass, Verdict::Pass), Verdict::Pass);
    EXPECT_EQ(passed(Verdict::Undecided), std::nullopt);
    EXPECT_EQ(passed(Verdict::Fail), false);
}

}  // namespace
}  // namespace lathelier
