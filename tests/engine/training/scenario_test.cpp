// Scenarios: limits and frequencies that make sense in a class, and the numbers of the published example.
#include "engine/training/scenario.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/training/lesson_state.h"

namespace lathelier::training {
namespace {

using stability::SpeedRelation;

TEST(Scenario, LimitsAndFrequenciesMakeSense)
{
    std::set<std::string> keys;
    for (const Scenario& scenario : scenarios()) {
        SCOPED_TRACE(scenario.key);
        EXPECT_TRUE(keys.insert(scenario.key).second);
        EXPECT_EQ(findScenario(scenario.key), &scenario);
        EXPECT_FALSE(scenario.name.empty() || scenario.description.empty());
        EXPECT_GE(scenario.modes.size(), 1U);
        EXPECT_LE(scenario.modes.size(), 3U);
        const Limits limits = limitsOf(scenario);
        EXPECT_GT(*limits.exact.minimum_depth_mm, 0.2);
        EXPECT_LT(*limits.exact.minimum_depth_mm, 3);
        EXPECT_EQ(limits.exact.limit.speed_rpm.size(), limits.published.limit.speed_rpm.size());
        int pockets = 0;
        const std::vector<double>& depth = limits.exact.limit.depth_mm;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            EXPECT_FALSE(std::isnan(depth[i]));
            EXPECT_GT(limits.exact.limit.frequency_hz[i], 150);
            EXPECT_LT(limits.exact.limit.frequency_hz[i], 900);
            EXPECT_LT(depth[i], 6);
            pockets += i > 0 && i + 1 < depth.size() && depth[i] > depth[i - 1] && depth[i] >= depth[i + 1];
        }
        EXPECT_GE(pockets, 6);
        // Distinct: the best pocket is at least twice as deep as the limit at every speed, and is shown.
        const double best = *std::max_element(depth.begin(), depth.end());
        EXPECT_GT(best, 2 * *limits.exact.minimum_depth_mm);
        EXPECT_GT(scenario.greatest_depth_mm, 0.95 * best);
        EXPECT_LT(scenario.start_depth_mm, *limits.exact.minimum_depth_mm);  // starts stable
        EXPECT_GT(scenario.start_speed_rpm, scenario.speed_rpm.from);
        EXPECT_LT(scenario.start_speed_rpm, scenario.speed_rpm.to);
    }
    EXPECT_EQ(findScenario("none"), nullptr);
}

/// The example of dynamics: f 223 Hz, ζ .03, k 1e7 N/m, K_r 2e9 N/m².
TEST(Scenario, SlenderIsThePublishedExample)
{
    const Scenario& slender = *findScenario("slender");
    const std::vector<std::array<double, 3>> rows{{2600, 0.5249, 0.9325}, {2800, 0.3789, 0.3410},
                                                  {2885, 0.3098, 0.4702}, {3250, 0.6487, 1.2155},
                                                  {3444, 0.6035, 0.3090}, {4200, 0.7003, 1.4660}};
    for (const auto& [speed, exact, published] : rows) {
        EXPECT_NEAR(limit_mm(slender, speed, SpeedRelation::Exact), exact, 1.5e-4) << speed;
        EXPECT_NEAR(limit_mm(slender, speed, SpeedRelation::Published), published, 1.5e-4) << speed;
    }
}

TEST(Scenario, StiffnessAndDampingRaiseTheLimit)
{
    const auto least = [](const char* key) { return *limitsOf(*findScenario(key)).exact.minimum_depth_mm; };
    EXPECT_GT(least("tailstock"), 2 * least("slender"));
    EXPECT_GT(least("rigid"), least("tailstock"));
    EXPECT_LT(least("worn_bearing"), least("rigid") / 4);
}

TEST(Scenario, TheStateOfACutHasItsPhase)
{
    const Scenario& slender = *findScenario("slender");
    const Limits limits = limitsOf(slender);
    const LessonState quick = stateOf(slender, limits, SpeedRelation::Exact, 2885, 0.4);
    const LessonState whole =
        stateOf(slender, limits, SpeedRelation::Exact, stability::simulate(slender.modes, cutOf(slender, 2885, 0.4)));
    for (const LessonState& state : {quick, whole}) {
        EXPECT_EQ(state.scenario, "slender");
        EXPECT_EQ(state.verdict, stability::CutVerdict::Chatter);
        EXPECT_GT(state.growth_per_revolution, 1);
        EXPECT_EQ(state.k, 4);
        EXPECT_GT(state.phase_deg, 180);
        EXPECT_LT(state.phase_deg, 360);
        EXPECT_NEAR(state.waves_per_revolution, state.k + state.phase_deg / 360, 1e-12);
        EXPECT_NEAR(state.limit_mm, 0.3098, 2e-4);
        EXPECT_NEAR(state.published_limit_mm, 0.4702, 2e-4);
        EXPECT_NEAR(state.minimum_depth_mm, 0.3090, 1e-4);
        EXPECT_LE(state.robust_limit_mm, state.limit_mm);
        EXPECT_GE(state.robust_limit_mm, state.minimum_depth_mm - 1e-9);
        EXPECT_EQ(state.natural_frequency_hz, 223);
    }
    EXPECT_NEAR(quick.growth_per_revolution, whole.growth_per_revolution, 2e-3);
    EXPECT_TRUE(std::isnan(quick.amplitude_mm));
    EXPECT_GT(whole.lost_contact_percent, 0);
}

/// Lengths, forces and times in other units: every number of the state scales by its own exponent.
TEST(Scenario, TheStateHasItsDimensions)
{
    const double length = 3, force = 7, time = 0.5;
    const Scenario& tailstock = *findScenario("tailstock");
    Scenario scaled = tailstock;
    for (stability::Mode& mode : scaled.modes) {
        mode.frequency_hz /= time;
        mode.stiffness_N_mm *= force / length;
    }
    scaled.cutting_coefficient_N_mm2 *= force / (length * length);
    scaled.feed_mm_rev *= length;
    scaled.diameter_mm *= length;
    scaled.speed_rpm = {tailstock.speed_rpm.from / time, tailstock.speed_rpm.to / time};
    const auto at = [](const Scenario& scenario, double speed_rpm, double depth_mm) {
        return stateOf(scenario, limitsOf(scenario), SpeedRelation::Exact,
                       stability::simulate(scenario.modes, cutOf(scenario, speed_rpm, depth_mm, 6000 / speed_rpm)));
    };
    const LessonState a = at(tailstock, 2700, 1.3), b = at(scaled, 2700 / time, 1.3 * length);
    const auto expect = [](double value, double other, double factor) {
        EXPECT_NEAR(other, value * factor, 1e-6 * std::abs(value * factor));
    };
    expect(a.growth_per_revolution, b.growth_per_revolution, 1);
    expect(a.frequency_hz, b.frequency_hz, 1 / time);
    expect(a.natural_frequency_hz, b.natural_frequency_hz, 1 / time);
    expect(a.amplitude_mm, b.amplitude_mm, length);
    expect(a.lost_contact_percent, b.lost_contact_percent, 1);
    expect(a.waves_per_revolution, b.waves_per_revolution, 1);
    expect(a.phase_deg, b.phase_deg, 1);
    EXPECT_NEAR(b.limit_mm, a.limit_mm * length, 1e-3 * b.limit_mm);  // lines of the response are not scaled
    EXPECT_NEAR(b.published_limit_mm, a.published_limit_mm * length, 1e-3 * b.published_limit_mm);
    EXPECT_NEAR(b.robust_limit_mm, a.robust_limit_mm * length, 1e-3 * b.robust_limit_mm);
    EXPECT_NEAR(b.minimum_depth_mm, a.minimum_depth_mm * length, 1e-3 * b.minimum_depth_mm);
}

}  // namespace
}  // namespace lathelier::training
