#include "engine/registration/neighbours/cloud_figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/registration/neighbours/cloud_distance.h"
#include "engine/registration/neighbours/points_near.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// A cylinder Ø30 × 80 with noise, in any order; every hundredth point lies up to `stray_mm` off it.
Points cylinder(std::size_t count, std::uint64_t seed, double stray_mm = 0)
{
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * randomUniform(seed, 0, i);
        const double off = i % 100 == 0 ? stray_mm * randomUniform(seed, 3, i) : 0;
        const double r = 15 + off + 0.02 * randomNormal(seed, 1, i);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), 80 * randomUniform(seed, 2, i));
    }
    return points;
}

double rms(const std::vector<float>& distances)
{
    double squares = 0, count = 0;
    for (const float d : distances)
        if (!std::isnan(d)) {
            squares += static_cast<double>(d) * d;
            count += 1;
        }
    return std::sqrt(squares / count);
}

/// Few questions to a large cloud go another way: the answers are those of the whole, also far from all points.
TEST(CloudFigure, FewQueriesToManyPointsGiveTheSameFigure)
{
    const Points reference = cylinder(50000, 1);
    const Points copy = cylinder(1000, 2, 30);
    std::vector<std::uint8_t> used(copy.size(), 1);
    for (const double reach : {0.5, 10.0, 1e9}) {
        const CloudFigure few = compareClouds(reference, copy, used, reach, {});
        EXPECT_DOUBLE_EQ(few.rmse_mm, rms(nearestDistances(reference, copy, reach))) << reach;
        EXPECT_EQ(few.standard_error_mm, 0);
    }
    // More of them are asked of an index of the whole.
    const Points many = cylinder(2000, 2, 30);
    const CloudFigure whole = compareClouds(reference, many, std::vector<std::uint8_t>(many.size(), 1), 1, {});
    EXPECT_DOUBLE_EQ(whole.rmse_mm, rms(nearestDistances(reference, many, 1)));
    EXPECT_NEAR(compareClouds(reference, copy, used, 1, {}).sampling_floor_mm, whole.sampling_floor_mm, 1e-12);
}

TEST(CloudFigure, OfManyPointsTheDrawnOnesTellWithinTheStandardError)
{
    const Points reference = cylinder(60000, 1);
    const Points copy = cylinder(120000, 2);
    const CloudFigure drawn = compareClouds(reference, copy, std::vector<std::uint8_t>(copy.size(), 1), 1, {});
    EXPECT_GT(drawn.standard_error_mm, 0.001 * drawn.rmse_mm);
    EXPECT_LT(drawn.standard_error_mm, 0.01 * drawn.rmse_mm);
    EXPECT_NEAR(drawn.rmse_mm, rms(nearestDistances(reference, copy, 1)), 3 * drawn.standard_error_mm);
}

TEST(PointsNear, HoldsAllWithinTheRadiusAndNotTheRest)
{
    const Points points = cylinder(20000, 3);
    const Points places(points.begin(), points.begin() + 20);
    const Points near = pointsNear(points, {{places, 0.5}, {{Eigen::Vector3d(1000, 0, 0)}, 2}});
    EXPECT_LT(near.size(), points.size() / 10);
    std::size_t next = 0;
    for (const Eigen::Vector3d& point : points) {
        if (next < near.size() && near[next] == point)
            ++next;  // in the order given
        else
            for (const Eigen::Vector3d& place : places) ASSERT_GT((point - place).norm(), 0.5);
    }
    EXPECT_EQ(next, near.size());
    EXPECT_TRUE(pointsNear({}, {{places, 1}}).empty());
    EXPECT_EQ(pointsNear(points, {{places, 0}}).size(), points.size());
}

TEST(QuickTurn, IsTheDirection)
{
    for (int i = -720; i <= 720; ++i) {
        const double turn = i / 1440.0;
        const double angle = 2 * std::numbers::pi * turn;
        const double found = quickTurn(3 * std::sin(angle), 3 * std::cos(angle));
        EXPECT_NEAR(std::remainder(found - turn, 1), 0, 5e-9) << i;
        EXPECT_LE(std::abs(found), 0.5);
    }
    EXPECT_EQ(quickTurn(0, 0), 0);
}

}  // namespace
}  // namespace lathelier::registration
