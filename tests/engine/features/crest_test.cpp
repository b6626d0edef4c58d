// Crests of threads, the cones that lead into them, and walls that a flat cuts into.
#include "engine/features/walls/crest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lathelier::features {
namespace {

/// A thread Ø16 × 2 that begins on a chamfer from Ø13, 1.5 mm long, as rays with noise along the radius and a spot of
/// 0.15 mm see it.
MeridianCloud threadedEnd(std::uint64_t seed, double sigma_mm)
{
    constexpr double pitch = 2, depth = 0.625 * 0.866 * pitch, spot = 0.15;
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0, sigma_mm);
    std::uniform_real_distribution<double> within(-spot / 2, spot / 2);
    MeridianCloud cloud;
    for (double row = 0.05; row < 27; row += 0.1)
        for (int k = 0; k < 400; ++k) {
            const double turn = k / 400.0, z = row + 0.01 * std::sin(2 * M_PI * turn), at = z + within(random);
            const double phase = at / pitch - turn, off = std::abs(phase - std::floor(phase) - 0.5) * pitch;
            const double cut = std::clamp((pitch * 7 / 16 - off) * std::sqrt(3.0), 0.0, depth);
            const double r = std::min(8 - cut, std::min(8.0, 6.5 + at));
            cloud.z_mm.push_back(static_cast<float>(z));
            cloud.r_mm.push_back(static_cast<float>(r + noise(random)));
            cloud.turn.push_back(static_cast<float>(turn));
        }
    cloud.z_first_mm = 0;
    cloud.z_last_mm = 27;
    return cloud;
}

TEST(Crest, OfAThread)
{
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const MeridianCloud cloud = threadedEnd(seed, 0.05);
        std::vector<float> radii;
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i)
            if (cloud.z_mm[i] > 3) radii.push_back(cloud.r_mm[i]);
        const auto crest = crestOf(radii, 0.05);
        ASSERT_TRUE(crest);
        EXPECT_NEAR(crest->radius_mm, 8, 4 * crest->sigma_mm);
        EXPECT_LT(crest->sigma_mm, 2e-3);
        sum += crest->radius_mm - 8;
    }
    EXPECT_NEAR(sum / 6, 0, 1.2e-3);  // counts are Poisson's: no bias toward the few
}

TEST(Crest, TheConeThatLeadsIn)
{
    for (const double sigma : {0.05, 0.1})
        for (std::uint64_t seed = 11; seed <= 14; ++seed) {
            const Lead lead = leadIn(threadedEnd(seed, sigma), 0.6, true, 4, 8, sigma);
            ASSERT_GE(lead.walls.size(), 3U) << seed;
            EXPECT_NEAR(lead.reached_mm, 1.5, 0.5 * sigma) << seed;
            for (const Wall& wall : lead.walls)
                EXPECT_NEAR(wall.r_mm, 6.5 + wall.z_mm, 0.6 * sigma) << seed << " at " << wall.z_mm;
        }
}

TEST(Crest, NoConeLeadsInAtAShoulder)
{
    EXPECT_TRUE(leadIn(threadedEnd(5, 0.05), 4, true, 4, 8, 0.05).walls.empty());
}

/// A cylinder Ø25 with two flats 22 mm apart over part of its length.
std::vector<Eigen::Vector3d> flattened(std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0, 0.05);
    std::vector<Eigen::Vector3d> points;
    for (double z = 0.03; z < 30; z += 0.1)
        for (int k = 0; k < 400; ++k) {
            const double turn = 2 * M_PI * k / 400, off = std::remainder(turn - 0.4, M_PI);
            const double flat = z > 10 && z < 24 ? 11 / std::cos(off) : 1e9;
            const double r = std::min(12.5, flat) + noise(random);
            points.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
        }
    return points;
}

TEST(Walls, FlatsLeaveThemAlone)
{
    const MeridianCloud cloud = meridianCloud(flattened(3));
    const Walls walls = findWalls(cloud, 0.1, 0.05);
    ASSERT_EQ(walls.chains.size(), 1U);
    double sum = 0, count = 0;
    for (const Wall& wall : walls.chains.front().walls) {
        if (wall.z_mm < 11 || wall.z_mm > 23) continue;
        EXPECT_NEAR(wall.sigma_mm, 0.05, 0.012) << wall.z_mm;
        sum += wall.r_mm - 12.5;
        count += 1;
    }
    ASSERT_GT(count, 100);
    EXPECT_NEAR(sum / count, 0, 1e-3);
}

}  // namespace
}  // namespace lathelier::features
