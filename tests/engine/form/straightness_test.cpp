#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/core/random.h"
#include "engine/form/cylinder/cylindricity.h"
#include "engine/form/cylinder/straightness.h"

namespace lathelier::form {
namespace {

using Eigen::Vector3d;

std::vector<Vector3d> posed(const std::vector<Vector3d>& points)
{
    const Eigen::Isometry3d pose = Eigen::Translation3d(100, -30, 700) *
                                   Eigen::AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()) *
                                   Eigen::Isometry3d::Identity();
    std::vector<Vector3d> result;
    for (const Vector3d& point : points) result.push_back(pose * point);
    return result;
}

TEST(Straightness, OfALineIsZero)
{
    const StraightnessResult result = straightness(posed({{0, 0, 0}, {0, 0, 10}, {0, 0, 35}, {0, 0, 100}}));
    EXPECT_NEAR(result.STRt_LSLI_um, 0, 1e-8);
    EXPECT_NEAR(result.STRt_MZLI_um, 0, 1e-8);
    EXPECT_NEAR(result.direction.norm(), 1, 1e-15);
    EXPECT_EQ(result.direction.maxCoeff(), result.direction.cwiseAbs().maxCoeff());  // toward + on the dominant one
}

TEST(Straightness, OfABowIsTheClosedForm)
{
    // x = 4 µm · u² at u = -1, 0, 1: the least-squares line at 8/3 µm; the narrowest strip is 4 µm wide, tilted or not.
    const StraightnessResult bow = straightness(posed({{0.004, 0, -50}, {0, 0, 0}, {0.004, 0, 50}}));
    EXPECT_NEAR(bow.STRt_LSLI_um, 2 * 8.0 / 3, 1e-6);
    EXPECT_NEAR(bow.axis_straightness_um, 4, 1e-6);
    EXPECT_NEAR(bow.STRt_MZLI_um, 4, 1e-6);
    // One point of five off by 6 µm at the end: the narrowest strip follows the tilt.
    const StraightnessResult kink =
        straightness(posed({{0, 0, 0}, {0, 0, 10}, {0, 0, 20}, {0, 0, 30}, {0.006, 0, 40}}));
    EXPECT_NEAR(kink.STRt_MZLI_um, 0.006 * 30 / 40 * 1000, 1e-6);
    EXPECT_GT(kink.axis_straightness_um, kink.STRt_MZLI_um);
}

TEST(Straightness, OfAHelixIsItsDiameterAtMost)
{
    std::vector<Vector3d> points;
    for (int i = 0; i < 200; ++i) points.emplace_back(0.01 * std::cos(0.4 * i), 0.01 * std::sin(0.4 * i), i);
    const StraightnessResult result = straightness(posed(points));
    EXPECT_NEAR(result.STRt_MZLI_um, 20, 0.05);
    EXPECT_LE(result.STRt_MZLI_um, result.axis_straightness_um);
    EXPECT_LE(result.axis_straightness_um, result.STRt_LSLI_um * (1 + 1e-12));
}

// No other axis does better: compared with the smallest circle along many directions near it.
TEST(Straightness, SmallestCylinderIsNotBeatenByAnyTilt)
{
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        std::vector<Vector3d> points;
        for (std::uint64_t i = 0; i < 20; ++i)
            points.emplace_back(0.003 * randomNormal(seed, 0, i), 0.003 * randomNormal(seed, 1, i),
                                5.0 * static_cast<double>(i));
        const StraightnessResult result = straightness(points);
        double best = std::numeric_limits<double>::infinity();
        for (std::uint64_t k = 0; k < 4000; ++k) {
            const double size = 1e-4 * std::pow(10, -3 * randomUniform(seed, 5, k));
            const Vector3d tilt(size * (randomUniform(seed, 3, k) - 0.5), size * (randomUniform(seed, 4, k) - 0.5), 0);
            std::vector<Vector3d> sheared = points;
            for (Vector3d& point : sheared) point -= point.z() * (tilt + result.direction / result.direction.z());
            // All lie in one plane now; the farthest pair bounds the circle from below.
            double farthest = 0;
            for (const Vector3d& a : sheared)
                for (const Vector3d& b : sheared) farthest = std::max(farthest, (a - b).head<2>().norm());
            best = std::min(best, farthest * 2 / std::sqrt(3.0));
        }
        EXPECT_LE(result.STRt_MZLI_um, 1000 * best);
        EXPECT_LE(result.STRt_MZLI_um, result.axis_straightness_um);
    }
}

TEST(Straightness, SaysWhyItHasNoAnswer)
{
    EXPECT_THROW(straightness({}), Error);
    EXPECT_THROW(straightness(std::vector<Vector3d>(5, Vector3d(1, 2, 3))), Error);
}

}  // namespace
}  // namespace lathelier::form
