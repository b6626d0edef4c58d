// Plateaus 4 mm across on scans from thin to dense and from quiet to noisy: never a pass; without them a pass.
#include <gtest/gtest.h>

#include "engine/registration/compare.h"
#include "engine/registration/verdict/verdict.h"
#include "tests/engine/registration/stepped_scan.h"
#include "tests/engine/registration/within_tolerance.h"

namespace lathelier::registration {
namespace {

using testing_steps::StepScans;
using testing_steps::stepsTwice;

constexpr std::uint64_t runs = 5;
constexpr double limit_mm = 0.08;

CompareResult compareSteps(const StepScans& scans)
{
    return compare(scans.reference, scans.copy, withinTolerance(limit_mm), {}, CompareDetail::Summary);
}

TEST(SmallDefect, NeverPasses)
{
    struct Kind {
        double sigma_mm;
        std::size_t points;
        bool is_found;  ///< the plateau holds enough points for a fail
    };
    for (const Kind& kind : {Kind{0.05, 20000, false}, Kind{0.08, 20000, false}, Kind{0.1, 60000, false},
                             Kind{0.05, 60000, true}, Kind{0.03, 60000, true}})
        for (std::uint64_t seed = 0; seed < runs; ++seed) {
            CompareResult result = compareSteps(stepsTwice(kind.points, kind.sigma_mm, 0.12, seed));
            for (const DecisionRule rule : decisionRules) {
                judge(result, withinTolerance(limit_mm, rule));
                EXPECT_NE(result.verdict, Verdict::Pass) << kind.sigma_mm << ' ' << kind.points << ' ' << seed;
                if (kind.is_found) {
                    EXPECT_EQ(result.verdict, Verdict::Fail) << kind.sigma_mm << ' ' << seed;
                }
            }
        }
}

/// Here the disc holds 11 points, half of what is usual: no window about it is sure, which decides nothing.
TEST(SmallDefect, OnAThinPlaceIsNotDecided)
{
    CompareResult result = compareSteps(stepsTwice(20000, 0.05, 0.12, 86));
    for (const DecisionRule rule : decisionRules) {
        judge(result, withinTolerance(limit_mm, rule));
        EXPECT_NE(result.verdict, Verdict::Pass) << key(rule);
    }
}

TEST(SmallDefect, TheSameShapePassesByEveryRule)
{
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        CompareResult result = compareSteps(stepsTwice(60000, 0.03, 0, seed));
        EXPECT_TRUE(result.findings.empty()) << seed;
        for (const DecisionRule rule : decisionRules) {
            judge(result, withinTolerance(limit_mm, rule));
            EXPECT_EQ(result.verdict, Verdict::Pass) << seed;
        }
    }
}

/// A face seen through noise is no thread: its bins must not become part of the outline.
TEST(SmallDefect, FacesOfTheSameShapeAreNoFindings)
{
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        const CompareResult result = compareSteps(stepsTwice(60000, 0.1, 0, seed));
        EXPECT_TRUE(result.findings.empty()) << seed;
        EXPECT_NE(result.verdict, Verdict::Fail) << seed;
    }
}

}  // namespace
}  // namespace lathelier::registration
