// Value, uncertainty, limit and verdict of the answers about form agree, whatever the rule and the limit.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/form/cylinder/cylindricity.h"
#include "engine/form/cylinder/cylindricity_report.h"
#include "engine/form/roundness/roundness.h"
#include "engine/form/roundness/roundness_report.h"
#include "tests/engine/report/answer_agrees.h"

namespace lathelier::form {
namespace {

using testing_answer::expectAgrees;

/// Limits from far below the value to far above it, close together about it.
std::vector<double> limitsAbout(double value, double U)
{
    std::vector<double> limits;
    for (const double k : {-3.0, -1.1, -0.9, -0.1, 0.0, 0.1, 0.9, 1.1, 3.0}) limits.push_back(value + k * U);
    std::erase_if(limits, [](double limit) { return limit < 0; });
    return limits;
}

TEST(FormAnswer, RoundnessAgreesWithItsVerdict)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Profile profile;
        for (std::uint64_t k = 0; k < 360; ++k) {
            const double angle = std::numbers::pi * static_cast<double>(k) / 180;
            const double r = 20 + 0.002 * std::cos(3 * angle) + 0.0004 * randomNormal(seed, 1, k);
            profile.points_mm.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        RoundnessParameters parameters;
        parameters.probe_uncertainty_um = 0.4;
        const RoundnessResult free = roundness(profile, parameters);
        const double value = headlineDeviation_um(free), U = free.RONt_expanded_uncertainty_um;
        ASSERT_GT(U, 0);
        for (const double limit : limitsAbout(value, U))
            for (const DecisionRule rule : decisionRules) {
                parameters.tolerance_um = limit;
                parameters.decision = rule;
                expectAgrees(answer(roundness(profile, parameters)), rule, std::to_string(limit));
            }
    }
}

TEST(FormAnswer, CylindricityAgreesWithItsVerdict)
{
    std::vector<Eigen::Vector3d> points;
    for (std::uint64_t k = 0; k < 400; ++k) {
        const double angle = 2.4 * static_cast<double>(k), z = 0.1 * static_cast<double>(k);
        const double r = 10 + 0.003 * std::cos(2 * angle) + 0.0005 * randomNormal(1, 2, k);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    CylindricityParameters parameters;
    parameters.probe_uncertainty_um = 0.5;
    CylindricityResult result = cylindricity(points, parameters);
    ASSERT_GT(result.CYLt_expanded_uncertainty_um, 0);
    for (const double limit : limitsAbout(result.MZCY.CYLt_um, result.CYLt_expanded_uncertainty_um))
        for (const DecisionRule rule : decisionRules) {
            parameters.tolerance_um = limit;
            parameters.decision = rule;
            judge(result, parameters);
            expectAgrees(answer(result), rule, std::to_string(limit));
        }
}

}  // namespace
}  // namespace lathelier::form
