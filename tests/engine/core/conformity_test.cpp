#include "engine/core/conformity.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

TEST(Conformity, GuardedRejectionFailsOnlyWhatIsSurelyOut)
{
    EXPECT_EQ(judge(10, 5, 10, DecisionRule::GuardedRejection), Verdict::Pass);
    EXPECT_EQ(judge(0.05, 0.32, 0, DecisionRule::GuardedRejection), Verdict::Undecided);
    EXPECT_EQ(judge(12, 2, 10, DecisionRule::GuardedRejection), Verdict::Undecided);
    EXPECT_EQ(judge(12.1, 2, 10, DecisionRule::GuardedRejection), Verdict::Fail);
    EXPECT_EQ(judge(10.1, std::nan(""), 10, DecisionRule::GuardedRejection), Verdict::Undecided);
    EXPECT_EQ(judge(9.9, std::nan(""), 10, DecisionRule::GuardedRejection), Verdict::Pass);
}

/// Whatever the rule: what passes has its value within the limit, so that an interval that lies beyond it is never
/// within; what fails by a rule that counts U has no part of its interval within.
RC_GTEST_PROP(Conformity, ValueUncertaintyAndVerdictAreOneInequality, ())
{
    const auto drawn = [] { return *rc::gen::inRange(-2000, 2000) / 100.0; };
    const double value = drawn(), limit = drawn(), U = std::abs(drawn());
    const Verdict rejection = judge(value, U, limit, DecisionRule::GuardedRejection);
    const Verdict simple = judge(value, U, limit, DecisionRule::Simple);
    const Verdict guarded = judge(value, U, limit, DecisionRule::Guarded);
    for (const Verdict verdict : {rejection, simple, guarded})
        if (verdict == Verdict::Pass) RC_ASSERT(value <= limit);
    RC_ASSERT((guarded == Verdict::Pass) == (value + U <= limit));
    RC_ASSERT((guarded == Verdict::Fail) == (value - U > limit));
    RC_ASSERT((rejection == Verdict::Fail) == (value - U > limit));
    RC_ASSERT((rejection == Verdict::Pass) == (simple == Verdict::Pass));
    RC_ASSERT(simple != Verdict::Undecided);
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
