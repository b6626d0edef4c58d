// The speed to cut at by the depth of cut: against limits that are found here by their own equation.
#include "engine/stability/safe_speed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/stability/modes.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::stability {
namespace {

const std::vector<Mode> paperRod{{223, 0.03, 1e4}};

/// The limit at one speed by definition: the least -1/(2 K Re G) among all frequencies whose phase closes at it.
double limitByPhase(double speed_rpm, double coefficient)
{
    double least = HUGE_VAL, previous_phase = 0, previous_depth = 0;
    bool had = false;
    for (double f = 223.01; f < 600; f += 0.002) {
        const std::complex<double> g = receptanceOf(paperRod, f);
        if (g.real() >= 0) {
            had = false;
            continue;
        }
        const double epsilon = 3 * std::numbers::pi + 2 * std::arg(g);
        const double phase = 60 * f / speed_rpm - epsilon / (2 * std::numbers::pi);
        const double depth = -1 / (2 * coefficient * g.real());
        if (had && std::floor(phase) != std::floor(previous_phase)) least = std::min({least, depth, previous_depth});
        had = true;
        previous_phase = phase;
        previous_depth = depth;
    }
    return least;
}

LobeParameters withCoefficient(double coefficient)
{
    LobeParameters lobes;
    lobes.cutting_coefficient_N_mm2 = coefficient;
    return lobes;
}

TEST(SafeSpeed, LimitsAreThoseOfTheEquation)
{
    const SafeSpeed safe = safeSpeed(frfOf(paperRod, 10000), withCoefficient(2000), {2885, 0.5, {2500, 4500}});
    EXPECT_NEAR(*safe.selected.limit, limitByPhase(2885, 2000), 2e-3 * *safe.selected.limit);
    EXPECT_EQ(safe.selected.is_stable, 0.5 < *safe.selected.limit);
    ASSERT_FALSE(safe.peaks.empty());
    for (const DepthAtSpeed& peak : safe.peaks) {
        EXPECT_NEAR(*peak.limit, limitByPhase(peak.speed_rpm, 2000), 5e-3 * *peak.limit) << peak.speed_rpm;
        EXPECT_NEAR(*peak.margin, *peak.limit - 0.5, 1e-12);
    }
}

TEST(SafeSpeed, NoSpeedOfTheRangeBearsMoreWithinTwoPercent)
{
    const SafeSpeed safe = safeSpeed(frfOf(paperRod, 10000), withCoefficient(2000), {3000, 0.2, {2600, 4000}});
    const auto leastAbout = [](double speed_rpm) {
        double least = HUGE_VAL;
        for (double share = -0.02; share <= 0.0201; share += 0.002)
            least = std::min(least, limitByPhase(speed_rpm * (1 + share), 2000));
        return least;
    };
    const double best = leastAbout(safe.best.speed_rpm);
    for (double speed = 2600; speed <= 4000; speed += 50) EXPECT_LE(leastAbout(speed), best * 1.01) << speed;
    EXPECT_TRUE(safe.recommendedRpm().has_value());
}

TEST(SafeSpeed, WhereNothingIsStableNothingIsRecommended)
{
    const SafeSpeed safe = safeSpeed(frfOf(paperRod, 10000), withCoefficient(2000), {2885, 5, {2700, 3100}});
    EXPECT_FALSE(safe.recommendedRpm().has_value());
    EXPECT_LT(*safe.best.margin, 0);
    const Json json = toJson(safe, false);
    EXPECT_EQ(json["stable_at_selected"], false);
    EXPECT_LT(json["best"]["margin_mm"].get<double>(), 0);
    EXPECT_EQ(findingsOf(safe, false, "speed").front().verdict, Verdict::Fail);
}

TEST(SafeSpeed, WhereNoLobeLimitsEverySpeedIsStable)
{
    LobeLimit limit{{1000, 1500, 2000}, {notANumber, notANumber, notANumber}, {}, {-1, -1, -1}};
    const SafeSpeed safe = safeSpeedOn(limit, {1400, 3, {1000, 2000}});
    EXPECT_TRUE(safe.selected.is_stable);
    EXPECT_FALSE(safe.best.limit.has_value());
    EXPECT_EQ(safe.best.speed_rpm, 1500);  // the nearest to the selected one
}

TEST(SafeSpeed, RangeAndSelectedSpeedHaveToLieWithinTheLimit)
{
    LobeLimit limit{{1000, 1500, 2000}, {1, 2, 1}, {1, 1, 1}, {1, 1, 1}};
    EXPECT_THROW(safeSpeedOn(limit, {1400, 3, {2100, 2200}}), Error);
    EXPECT_THROW(safeSpeedOn(limit, {900, 3, {1000, 2000}}), Error);
}

}  // namespace
}  // namespace lathelier::stability
