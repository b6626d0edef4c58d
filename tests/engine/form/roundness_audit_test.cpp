// Derived numbers where the data are uneven, interrupted, coarse or off centre: bounded, omitted, or noted.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/form/form_codes.h"
#include "engine/form/roundness/roundness.h"
#include "tests/engine/form/exact_points.h"
#include "tests/engine/form/made_profile.h"

namespace lathelier::form {
namespace {

TEST(Roundness, TwoPointSizesStayWithinTwiceTheDeviationHoweverUneven)
{
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        std::vector<double> angle;
        for (std::size_t i = 0; i < 60; ++i) {
            // pairs that nearly touch, and wide steps between them
            const double at = 2 * std::numbers::pi * static_cast<double>(i / 2) / 30;
            angle.push_back(at + (i % 2 ? 1e-4 + .02 * randomUniform(seed, 0, i) : 0));
        }
        const RoundnessResult result = roundness(lobedProfile(angle, {{2, .05, 1}, {9, .2, 0}}, {0, 0}, .05, seed));
        EXPECT_LE(result.two_point.range_um, 2 * result.circles.LSCI.RONt_um * (1 + 1e-9)) << seed;
        EXPECT_GT(result.two_point.smallest_mm, 49);
    }
}

TEST(Roundness, DirectionsWithoutTwoPointSizeAreNamed)
{
    std::vector<double> angle;
    for (const double a : evenAngles(720))
        if (a > .3) angle.push_back(a);
    const RoundnessResult result = roundness(lobedProfile(angle, {{2, .005, 1}}), exact());
    EXPECT_NEAR(static_cast<double>(result.two_point.without_opposite), 720 * .3 / (2 * std::numbers::pi), 2);
    EXPECT_TRUE(contains(result.notes, notes::twoPointIncomplete));
}

TEST(Roundness, ATraceFarOffCentreOnANominalRadiusSaysWhatThatMayDo)
{
    // The same trace laid on two radii: its roundness differs, and each statement covers the other.
    const auto laid = [](double radius_mm) {
        Profile profile;
        profile.size_is_nominal = true;
        for (const double a : evenAngles(360)) {
            const double r = radius_mm + .3 * std::cos(a) + .001 * std::cos(3 * a);
            profile.points_mm.emplace_back(r * std::cos(a), r * std::sin(a));
        }
        return roundness(profile);
    };
    const RoundnessResult small = laid(10), large = laid(40);
    const double difference = headlineDeviation_um(small) - headlineDeviation_um(large);
    EXPECT_GT(std::abs(difference), 2);
    EXPECT_LT(std::abs(difference), small.RONt_expanded_uncertainty_um);
    EXPECT_TRUE(contains(small.notes, notes::nominalRadiusMatters));
    const double e = .3;
    EXPECT_NEAR(small.RONt_expanded_uncertainty_um, 1000 * e * e / (2 * 10), .01);
    Profile measured;
    for (const double a : evenAngles(360)) measured.points_mm.emplace_back(10 * std::cos(a) + .3, 10 * std::sin(a));
    EXPECT_FALSE(contains(roundness(measured).notes, notes::nominalRadiusMatters));
}

TEST(Roundness, StairStepsCountAsUncertainty)
{
    Profile profile;
    for (const double a : evenAngles(3600)) {
        const double r = std::round(1000 * (25 + .004 * std::cos(2 * a))) / 1000;
        profile.points_mm.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    const RoundnessResult result = roundness(profile);
    EXPECT_NEAR(result.resolution_um, 1, 1e-6);
    EXPECT_GE(result.point_noise_um, 1 / std::sqrt(12.0) - 1e-9);
    EXPECT_GT(result.RONt_expanded_uncertainty_um, .5);
    EXPECT_TRUE(contains(result.notes, notes::resolutionCounted));
}

TEST(Roundness, HarmonicsThatAreLeftOutOrEstimatedAreNamed)
{
    std::vector<double> uneven, keyway;
    for (const double a : evenAngles(200)) uneven.push_back(a + .4 * std::sin(a));
    for (const double a : evenAngles(3600))
        if (a > .14) keyway.push_back(a);
    EXPECT_TRUE(contains(roundness(lobedProfile(uneven, {{2, .005, 1}})).notes, notes::harmonicsLimited));
    EXPECT_TRUE(contains(roundness(lobedProfile(keyway, {{2, .005, 1}})).notes, notes::harmonicsEstimated));
    EXPECT_FALSE(contains(roundness(lobedProfile(evenAngles(200), {{2, .005, 1}})).notes, notes::harmonicsLimited));
}

TEST(Roundness, RevolutionsThatLieOverEachOtherAreNamed)
{
    std::vector<double> once = evenAngles(720), three;
    for (std::size_t i = 0; i < 720; ++i) three.push_back(3 * once[i] + .001);
    EXPECT_TRUE(contains(roundness(lobedProfile(three, {{2, .005, 1}})).notes, notes::revolutionsOverlaid));
    EXPECT_FALSE(contains(roundness(lobedProfile(once, {{2, .005, 1}})).notes, notes::revolutionsOverlaid));
    std::vector<double> mixed;
    for (std::size_t i = 0; i < 720; ++i) mixed.push_back(once[i * 197 % 720]);
    EXPECT_FALSE(contains(roundness(lobedProfile(mixed, {{2, .005, 1}})).notes, notes::revolutionsOverlaid));
}

}  // namespace
}  // namespace lathelier::form
