// Whether value, expanded uncertainty, limits and verdict of an answer are one inequality (core/conformity.h).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "engine/core/conformity.h"
#include "engine/report/answer.h"

namespace lathelier::testing_answer {

inline void expectAgrees(const report::Answer& answer, DecisionRule rule, const std::string& what)
{
    ASSERT_TRUE(answer.value && answer.verdict) << what;
    const double U = answer.expanded_uncertainty.value_or(0);
    const double beyond =
        std::max(*answer.value - answer.upper_limit.value_or(std::numeric_limits<double>::infinity()),
                 answer.lower_limit.value_or(-std::numeric_limits<double>::infinity()) - *answer.value);
    if (*answer.verdict == Verdict::Pass) {
        EXPECT_LE(beyond, 0) << what << ": within, but the value lies outside";
        if (rule == DecisionRule::Guarded) {
            EXPECT_LE(beyond + U, 0) << what << ": within, but not surely";
        }
    }
    if (*answer.verdict == Verdict::Fail) {
        EXPECT_GT(beyond, 0) << what << ": out, but the value lies within";
        if (rule != DecisionRule::Simple) {
            EXPECT_GT(beyond - U, 0) << what << ": out, but not surely";
        }
    }
    if (beyond - U > 0) {
        EXPECT_EQ(*answer.verdict, Verdict::Fail) << what << ": all of the interval lies outside";
    }
}

}  // namespace lathelier::testing_answer
