// Points that were not measured are left out, and nothing else.
#include "engine/form/cylinder/phantom_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/form/cylinder/cylindricity.h"
#include "engine/form/form_codes.h"

namespace lathelier::form {
namespace {

using Eigen::Vector3d;

/// Random places on a cylinder of radius 10 about (3, 0).
std::vector<Vector3d> cylinderPoints(std::size_t count)
{
    std::vector<Vector3d> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = 2 * std::numbers::pi * randomUniform(3, 0, i);
        points.emplace_back(3 + 10 * std::cos(t), 10 * std::sin(t), 40 * randomUniform(3, 1, i));
    }
    return points;
}

TEST(PhantomPoints, EqualPointsAtOnePlaceAreLeftOut)
{
    for (const std::size_t count : {300UL, 60000UL})
        for (const Vector3d& place : {Vector3d(0, 0, 0), Vector3d(-9999, -9999, -9999), Vector3d(3, 1, 20)}) {
            const std::size_t phantoms = count / 2;
            const std::vector<Vector3d> measured = cylinderPoints(count);
            std::vector<Vector3d> points(phantoms, place);
            points.insert(points.end(), measured.begin(), measured.end());
            const CylindricityResult result = cylindricity(points, {}, {}, NoiseEstimate::LeftOut);
            EXPECT_NEAR(result.LSCY.radius_mm, 10, 1e-9);
            EXPECT_EQ(result.points, points.size());
            EXPECT_EQ(result.points_left_out, phantoms);
            EXPECT_TRUE(contains(result.notes, notes::phantomPoints));
            for (const std::size_t contact : result.MZCY.contacts) EXPECT_GE(contact, phantoms);
        }
}

TEST(PhantomPoints, AFewAtTheOriginAreEnough)
{
    std::vector<Vector3d> points = cylinderPoints(100);
    for (int i = 0; i < 3; ++i) points.emplace_back(0, 0, 0);
    Notes notes;
    EXPECT_EQ(withoutPhantoms(points, notes).size(), 100U);
}

TEST(PhantomPoints, RepeatedMeasurementsStay)
{
    Notes notes;
    const std::vector<Vector3d> once = cylinderPoints(200);
    EXPECT_TRUE(withoutPhantoms(once, notes).empty());
    // Each place twelve times, and the first of a section at its end again.
    std::vector<Vector3d> points;
    for (int i = 0; i < 12; ++i) points.insert(points.end(), once.begin(), once.end());
    EXPECT_TRUE(withoutPhantoms(points, notes).empty());
    std::vector<Vector3d> closed = once;
    closed.push_back(once.front());
    EXPECT_TRUE(withoutPhantoms(closed, notes).empty());
    // Nothing but one place is for the fit to refuse.
    EXPECT_TRUE(withoutPhantoms(std::vector<Vector3d>(100, Vector3d(1, 2, 3)), notes).empty());
    EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace lathelier::form
