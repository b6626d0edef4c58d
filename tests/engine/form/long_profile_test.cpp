// Fast paths for long profiles give the results of the general ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/core/random.h"
#include "engine/form/circle/two_point.h"
#include "engine/form/roundness/roundness.h"

namespace lathelier::form {
namespace {

/// An eccentric part of two lobes and noise, at even angles.
Profile longProfile(std::size_t n)
{
    Profile profile;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius =
            25 + 0.004 * std::cos(2 * angle) + 0.001 * std::cos(7 * angle + 1) + 0.001 * randomNormal(11, 0, i);
        profile.points_mm.emplace_back(radius * std::cos(angle) + 0.03, radius * std::sin(angle) - 0.01);
    }
    return profile;
}

TEST(LongProfile, OrderOfThePointsDoesNotMatter)
{
    const Profile profile = longProfile(20000);
    const ReferenceCircles ordered = fitCircles(profile.points_mm);
    const CaliperWidth width = caliperWidth(profile.points_mm);
    std::vector<std::size_t> place(profile.points_mm.size());
    std::iota(place.begin(), place.end(), std::size_t{0});
    std::sort(place.begin(), place.end(),
              [](std::size_t a, std::size_t b) { return randomBits(5, 0, a) < randomBits(5, 0, b); });
    std::vector<Eigen::Vector2d> shuffled;
    for (const std::size_t i : place) shuffled.push_back(profile.points_mm[i]);
    const ReferenceCircles other = fitCircles(shuffled);
    for (const ReferenceCircle which :
         {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI})
        EXPECT_NEAR(ordered.of(which).RONt_um, other.of(which).RONt_um, 1e-9);
    EXPECT_DOUBLE_EQ(caliperWidth(shuffled).largest_mm, width.largest_mm);
    EXPECT_DOUBLE_EQ(caliperWidth(shuffled).smallest_mm, width.smallest_mm);
}

/// From twice 8192 points on, filtered noise is drawn on fewer points.
TEST(LongProfile, UncertaintyOfFilteredPointsDoesNotDependOnTheWayOfDrawing)
{
    RoundnessParameters parameters;
    parameters.cutoff_upr = 50;
    const double by_all = roundness(longProfile(16383), parameters).RONt_expanded_uncertainty_um;
    const double by_some = roundness(longProfile(16385), parameters).RONt_expanded_uncertainty_um;
    EXPECT_GT(by_all, 0.05);
    EXPECT_NEAR(by_some / by_all, 1, 0.1);
}

/// From 65536 points on, the noise of neighbours is drawn at once.
TEST(LongProfile, UncertaintyDoesNotDependOnTheWayOfDrawing)
{
    for (const ReferenceCircle which : {ReferenceCircle::MZCI, ReferenceCircle::LSCI}) {
        RoundnessParameters parameters;
        parameters.circle = which;
        const double by_points = roundness(longProfile(65535), parameters).RONt_expanded_uncertainty_um;
        const double by_blocks = roundness(longProfile(65536), parameters).RONt_expanded_uncertainty_um;
        EXPECT_GT(by_points, 4);
        EXPECT_NEAR(by_blocks / by_points, 1, 0.06);
    }
}

/// Beyond some ten thousand points the rows of the table come from fewer, at even angles.
TEST(LongProfile, MethodsOfUnevenStepsAgreeWithRunsOfTheirOwn)
{
    Profile profile;
    constexpr std::size_t n = 30000;
    for (std::size_t i = 0; i < n; ++i) {
        const double turn = (static_cast<double>(i) + 0.6 * randomUniform(3, 0, i)) / n;
        const double angle = 2 * std::numbers::pi * turn;
        const double radius =
            25 + 0.004 * std::cos(2 * angle) + 0.002 * std::cos(13 * angle + 1) + 0.0003 * randomNormal(3, 1, i);
        profile.points_mm.emplace_back(radius * std::cos(angle) + 0.02, radius * std::sin(angle));
    }
    const RoundnessResult table = roundness(profile);
    ASSERT_GT(table.methods.size(), 1u);
    ASSERT_EQ(table.methods[1].band.high_upr, 15);
    RoundnessParameters parameters;
    parameters.cutoff_upr = 15;
    const RoundnessResult own = roundness(profile, parameters);
    EXPECT_EQ(own.filter_method, signal::FilterMethod::Series);  // else the table takes the same way
    for (const ReferenceCircle which :
         {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI})
        EXPECT_NEAR(table.methods[1].RONt_um[static_cast<std::size_t>(which)], own.circles.of(which).RONt_um, 1e-3);
}

}  // namespace
}  // namespace lathelier::form
