#include "engine/form/roundness/superimpose.h"
#include "engine/form/form_codes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/core/units.h"
#include "tests/engine/form/made_profile.h"

namespace lathelier::form {
namespace {

const std::vector<Lobe> formLobes{{2, .005, 1}, {3, .002, 2}, {5, .001, .4}, {9, .0007, 0}};

/// The profile turned, shifted, grown and if wanted mirrored (y becomes -y before the turn).
Profile movedProfile(const Profile& profile, double rotation_deg, Eigen::Vector2d shift_mm, double growth_mm,
                     bool mirrored)
{
    Profile result = profile;
    for (Eigen::Vector2d& point : result.points_mm) {
        point *= 1 + growth_mm / point.norm();
        if (mirrored) point.y() = -point.y();
        point = Eigen::Rotation2Dd(rotation_deg * rad_per_deg) * point + shift_mm;
    }
    return result;
}

double largestDistance(const Profile& first, const Profile& second, const SuperimposeResult& result)
{
    double largest = 0;
    for (std::size_t i = 0; i < first.points_mm.size(); ++i) {
        Eigen::Vector2d point = second.points_mm[i];
        if (result.mirrored) point.y() = -point.y();
        const Eigen::Vector2d laid = Eigen::Rotation2Dd(result.rotation_deg * rad_per_deg) * point + result.shift_mm;
        largest = std::max(largest, (laid - first.points_mm[i]).norm());
    }
    return largest;
}

TEST(Superimpose, RecoversRotationShiftAndRadius)
{
    const Profile first = lobedProfile(evenAngles(400), formLobes);
    for (const double rotation : {0.0, 0.37, 91.2, -170.0}) {
        const Profile second = movedProfile(first, rotation, {.3, -.2}, .01, false);
        const SuperimposeResult result = superimpose(first, second);
        EXPECT_NEAR(result.rotation_deg, -rotation, 2e-3) << rotation;
        EXPECT_NEAR(result.radius_difference_mm, .01, 1e-5);
        EXPECT_LT(result.largest_difference_um, .02);
        EXPECT_GT(result.correlation, .9999);
        EXPECT_TRUE(result.notes.empty());
        EXPECT_FALSE(result.mirrored);
    }
    const Profile second = movedProfile(first, 33, {.3, -.2}, 0, false);
    EXPECT_LT(largestDistance(first, second, superimpose(first, second)), 1e-3);
}

TEST(Superimpose, FindsAMirroredProfileWhenAsked)
{
    const Profile first = lobedProfile(evenAngles(360), formLobes, {1, 2});
    const Profile second = movedProfile(first, 40, {.1, .2}, 0, true);
    SuperimposeParameters parameters;
    EXPECT_GT(superimpose(first, second, parameters).largest_difference_um, .5);
    parameters.mirrored = true;
    const SuperimposeResult result = superimpose(first, second, parameters);
    EXPECT_TRUE(result.mirrored);
    EXPECT_LT(result.largest_difference_um, .02);
    EXPECT_LT(largestDistance(first, second, result), 1e-3);
}

TEST(Superimpose, StatesTheDifferencesOfTwoInstruments)
{
    // The paper's validation: image of the surface and trace of an instrument differ by 1.8 µm at most. Different
    // counts, centres and rotations must not add to the difference that is there: 1.8 µm cos 40θ.
    const Profile image = lobedProfile(evenAngles(200), formLobes, {.04, .03});
    std::vector<Lobe> seen = formLobes;
    seen.push_back({40, .0018, .3});
    Profile trace = lobedProfile(evenAngles(3600), seen, {-.2, .1});
    trace = movedProfile(trace, 75, {0, 0}, 0, false);
    const SuperimposeResult result = superimpose(image, trace);
    EXPECT_NEAR(result.rotation_deg, -75, .05);
    EXPECT_NEAR(result.largest_difference_um, 1.8, .1);
    EXPECT_NEAR(result.mean_difference_um, 1.8 * 2 / std::numbers::pi, .05);
    SuperimposeParameters parameters;
    parameters.form.cutoff_upr = 15;
    EXPECT_LT(superimpose(image, trace, parameters).largest_difference_um, .06);
}

TEST(Superimpose, WhatIsLeftOutIsNoDifference)
{
    const Profile image = lobedProfile(evenAngles(360), formLobes);
    Profile trace = image;
    trace.points_mm[100] *= 1.002;  // a grain of dust of tens of µm
    EXPECT_GT(superimpose(image, trace).largest_difference_um, 20);
    SuperimposeParameters parameters;
    parameters.form.outliers = OutlierRule::Hampel;
    EXPECT_LT(superimpose(image, trace, parameters).largest_difference_um, .05);
}

TEST(Superimpose, BesideAKeyway)
{
    std::vector<double> angle;
    for (const double a : evenAngles(720))
        if (a < 1 || a > 1.2) angle.push_back(a);
    const SuperimposeResult result = superimpose(
        lobedProfile(angle, formLobes), movedProfile(lobedProfile(evenAngles(720), formLobes), 20, {.05, 0}, 0, false));
    EXPECT_NEAR(result.rotation_deg, -20, .05);
    EXPECT_LT(result.largest_difference_um, .05);
}

TEST(Superimpose, SaysWhenTheFormDoesNotTellTheAngle)
{
    const Profile lobes = lobedProfile(evenAngles(360), {{3, .005, 0}});
    EXPECT_TRUE(contains(superimpose(lobes, lobes).notes, notes::rotationNotDetermined));
    EXPECT_NEAR(superimpose(lobes, lobes).rotation_deg, 0, 1e-3);
    const Profile round = lobedProfile(evenAngles(360), {});
    EXPECT_TRUE(contains(superimpose(round, round).notes, notes::rotationNotDetermined));
}

}  // namespace
}  // namespace lathelier::form
