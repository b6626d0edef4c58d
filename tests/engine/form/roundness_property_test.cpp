// What must hold for any profile: order of the deviations, invariance, uncertainty that covers.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>

#include "engine/core/parallel.h"
#include "engine/form/form_codes.h"
#include "engine/form/roundness/roundness.h"
#include "tests/engine/form/made_profile.h"

namespace lathelier::form {
namespace {

/// A random turned part: a few lobes, noise, somewhere in the plane.
Profile anyProfile()
{
    const auto n = static_cast<std::size_t>(*rc::gen::inRange(60, 400));
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000));
    std::vector<Lobe> lobes;
    for (const int upr : {2, 3, 5, 9})
        lobes.push_back({upr, .004 * randomUniform(seed, 1, static_cast<std::uint64_t>(upr)),
                         6 * randomUniform(seed, 2, static_cast<std::uint64_t>(upr))});
    std::vector<double> angle = evenAngles(n);
    for (std::size_t i = 0; i < n; ++i) angle[i] += .3 * 6.28 / static_cast<double>(n) * randomUniform(seed, 3, i);
    const Eigen::Vector2d centre(randomNormal(seed, 4, 0), randomNormal(seed, 4, 1));
    return lobedProfile(angle, lobes, centre, .0003, seed);
}

RoundnessParameters filtered()
{
    RoundnessParameters parameters;
    parameters.cutoff_upr = 15;
    return parameters;
}

RC_GTEST_PROP(RoundnessProperty, MinimumZoneIsTheSmallest, ())
{
    const RoundnessResult result = roundness(anyProfile(), filtered());
    for (const FittedCircle* circle : {&result.circles.LSCI, &result.circles.MICI, &result.circles.MCCI})
        RC_ASSERT(circle->RONt_um >= result.circles.MZCI.RONt_um - 1e-9);
}

RC_GTEST_PROP(RoundnessProperty, TurningShiftingAndOrderChangeNothing, ())
{
    const Profile profile = anyProfile();
    const double turn = *rc::gen::inRange(-180, 180) * std::numbers::pi / 180;
    Profile other;
    const std::size_t n = profile.points_mm.size();
    const Eigen::Rotation2Dd rotation(turn);
    for (std::size_t i = 0; i < n; ++i)
        other.points_mm.push_back(rotation * profile.points_mm[(n - 1 - i + n / 3) % n] + Eigen::Vector2d(-3, 5));
    for (const RoundnessParameters& parameters : {RoundnessParameters(), filtered()}) {
        const RoundnessResult a = roundness(profile, parameters), b = roundness(other, parameters);
        RC_ASSERT(std::abs(a.circles.MZCI.RONt_um - b.circles.MZCI.RONt_um) < 1e-6);
        RC_ASSERT(std::abs(a.circles.LSCI.RONt_um - b.circles.LSCI.RONt_um) < 1e-6);
        RC_ASSERT(std::abs(a.two_point.range_um - b.two_point.range_um) < 1e-6);
        for (const std::size_t k : {1u, 2u, 4u, 8u}) {
            RC_ASSERT(std::abs(a.harmonics[k].amplitude - b.harmonics[k].amplitude) < 1e-6);
            const double phase =
                b.harmonics[k].phase_rad - a.harmonics[k].phase_rad - (static_cast<double>(k) + 1) * turn;
            RC_ASSERT(std::abs(std::remainder(phase, 2 * std::numbers::pi)) * a.harmonics[k].amplitude < 1e-5);
        }
    }
}

RC_GTEST_PROP(RoundnessProperty, LengthsScale, ())
{
    const Profile profile = anyProfile();
    Profile larger = profile;
    for (Eigen::Vector2d& point : larger.points_mm) point *= 4;
    const RoundnessResult a = roundness(profile), b = roundness(larger);
    RC_ASSERT(std::abs(4 * a.circles.MZCI.RONt_um - b.circles.MZCI.RONt_um) < 1e-6);
    RC_ASSERT(std::abs(4 * a.two_point.caliper_largest_mm - b.two_point.caliper_largest_mm) < 1e-9);
    RC_ASSERT(std::abs(4 * a.point_noise_um - b.point_noise_um) < 1e-6);
    RC_ASSERT(std::abs(4 * a.RONt_expanded_uncertainty_um - b.RONt_expanded_uncertainty_um) <
              1e-3 * b.RONt_expanded_uncertainty_um);
}

TEST(RoundnessUncertainty, FindsTheNoiseOfThePoints)
{
    const std::vector<Lobe> lobes{{2, .005, 1}, {5, .002, 0}};
    EXPECT_NEAR(roundness(lobedProfile(evenAngles(3600), lobes, {.1, 0}, .0005)).point_noise_um, .5, .04);
    EXPECT_NEAR(roundness(lobedProfile(evenAngles(400), lobes, {.1, 0}, .0005)).point_noise_um, .5, .1);
    EXPECT_LT(roundness(lobedProfile(evenAngles(3600), lobes)).point_noise_um, .001);
}

TEST(RoundnessUncertainty, CoversTheTruthForEveryCircleAndFilter)
{
    // The same part measured many times: the value without noise lies within ± U at least 95 times in 100.
    const std::vector<Lobe> lobes{{2, .003, 1}, {3, .004, .5}};
    constexpr int measurements = 60;
    for (const bool filter : {false, true})
        for (const ReferenceCircle circle :
             {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI}) {
            RoundnessParameters parameters = filter ? filtered() : RoundnessParameters();
            parameters.circle = circle;
            const double truth = headlineDeviation_um(roundness(lobedProfile(evenAngles(300), lobes), parameters));
            int covered = 0;
            double sum = 0;
            for (int i = 0; i < measurements; ++i) {
                const RoundnessResult result = roundness(
                    lobedProfile(evenAngles(300), lobes, {.02, .01}, .0003, static_cast<std::uint64_t>(i) + 1),
                    parameters);
                const double error = std::abs(headlineDeviation_um(result) - truth);
                covered += error <= result.RONt_expanded_uncertainty_um;
                sum += result.RONt_expanded_uncertainty_um;
            }
            EXPECT_GE(covered, .93 * measurements) << name(circle) << (filter ? " filtered" : "");
            EXPECT_LT(sum / measurements, filter ? .6 : 2.4);  // and is not just large
            EXPECT_GT(sum / measurements, filter ? .1 : .4);
        }
}

TEST(RoundnessUncertainty, IsNotClaimedForAHandfulOfPoints)
{
    const RoundnessResult few = roundness(lobedProfile(evenAngles(12), {{2, .005, 0}}));
    EXPECT_TRUE(std::isnan(few.RONt_expanded_uncertainty_um));
    EXPECT_TRUE(contains(few.notes, notes::noiseNotKnown));
    RoundnessParameters parameters;
    parameters.probe_uncertainty_um = .2;
    const RoundnessResult stated = roundness(lobedProfile(evenAngles(12), {{2, .005, 0}}), parameters);
    EXPECT_GT(stated.RONt_expanded_uncertainty_um, .1);
    EXPECT_LT(stated.RONt_expanded_uncertainty_um, 1.5);
}

TEST(RoundnessUncertainty, IsTheSameForAnyNumberOfThreads)
{
    const Profile profile = lobedProfile(evenAngles(400), {{2, .005, 1}}, {.1, 0}, .0005);
    double one = 0;
    {
        const ThreadLimit limit(1);
        ASSERT_EQ(threadsAllowed(), 1u);
        one = roundness(profile, filtered()).RONt_expanded_uncertainty_um;
    }
    EXPECT_EQ(one, roundness(profile, filtered()).RONt_expanded_uncertainty_um);
}

}  // namespace
}  // namespace lathelier::form
