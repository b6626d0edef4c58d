// The headline of a comparison agrees with its verdict, whatever rule, limit and difference decide it.
#include <gtest/gtest.h>

#include "engine/registration/compare_report.h"
#include "engine/registration/verdict/verdict.h"
#include "tests/engine/registration/bumped_scan.h"
#include "tests/engine/registration/stepped_scan.h"
#include "tests/engine/registration/within_tolerance.h"
#include "tests/engine/report/answer_agrees.h"

namespace lathelier::registration {
namespace {

void expectAgreesForAllLimits(const Scan& reference, const Scan& copy, const std::string& what)
{
    CompareResult result = compare(reference, copy, {}, {}, CompareDetail::Summary);
    for (double limit_mm = 0.02; limit_mm < 0.2; limit_mm *= 1.12)
        for (const DecisionRule rule : decisionRules) {
            judge(result, withinTolerance(limit_mm, rule));
            testing_answer::expectAgrees(answer(result), rule,
                                         what + " " + std::to_string(limit_mm) + " " + std::string(key(rule)));
        }
}

TEST(CompareAnswer, AgreesWithItsVerdict)
{
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const testing_steps::StepScans scans = testing_steps::stepsTwice(30000, 0.05, seed == 0 ? 0 : 0.12, seed);
        expectAgreesForAllLimits(scans.reference, scans.copy, "steps " + std::to_string(seed));
    }
    const testing_bump::ShaftScans scans =
        testing_bump::shaftTwice(8, {.step_deg = 6.6, .copy = sample::copiedShaft()});
    expectAgreesForAllLimits(scans.reference, scans.copy, "sample");
}

}  // namespace
}  // namespace lathelier::registration
