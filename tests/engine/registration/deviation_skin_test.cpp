// The skin of a comparison: closed, with the copy's error where it was made.
#include "engine/registration/deviation_skin.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/parallel.h"
#include "tests/engine/registration/bumped_scan.h"

namespace lathelier::registration {
namespace {

using namespace testing_bump;

TEST(DeviationSkin, ShowsTheFormOfTheCopy)
{
    ShaftOptions options;
    options.copy = sample::copiedShaft();
    const ShaftScans scans = shaftTwice(5, options);
    const CompareResult result = compare(scans.reference, scans.copy);
    const Skin skin = deviationSkin(result);
    ASSERT_FALSE(skin.stations.empty());
    ASSERT_EQ(skin.values.size(), skin.vertexCount());
    const auto columns = static_cast<std::size_t>(skin.angle_count);
    const Eigen::Isometry3d part_T_axis = scans.reference_T_part.inverse() * result.axis_T_reference->inverse();
    double known = 0, sides = 0, squares = 0;
    for (std::size_t i = 0; i < skin.values.size(); ++i) {
        if (skin.stations[i / columns].isFace()) continue;
        ++sides;
        if (std::isnan(skin.values[i])) continue;
        const double z_mm = (part_T_axis * vertexOf(skin, i, 0)).z();
        const double truth = sample::radius_mm(options.copy, z_mm) - sample::radius_mm(sample::nominalShaft(), z_mm);
        if (std::abs(truth) > 0.2) continue;  // on the other side of a shoulder
        ++known;
        squares += std::pow(static_cast<double>(skin.values[i]) - truth, 2);
    }
    EXPECT_GT(known, 0.85 * sides);
    EXPECT_LT(std::sqrt(squares / known), 0.01);
}

/// A shaft with two end faces and a shoulder: the faces are where they are, and carry the copy's error along the axis.
TEST(DeviationSkin, FacesMoveAlongTheAxis)
{
    FacedShaft longer;
    longer.length_mm = 100.2;
    const ShaftScans scans = facedShafts(3, 0.01, 8, longer);
    const CompareResult result = compare(scans.reference, scans.copy);
    const Skin skin = deviationSkin(result);
    ASSERT_FALSE(skin.stations.empty());
    const auto columns = static_cast<std::size_t>(skin.angle_count);
    EXPECT_NEAR(skin.stations.back().z_mm - skin.stations.front().z_mm, 100, 0.1);
    bool has_shoulder = false;
    for (std::size_t row = 0; row < skin.stations.size(); ++row) {
        const SkinStation& station = skin.stations[row];
        has_shoulder = has_shoulder || (station.isFace() && station.radius_mm > 16 && station.radius_mm < 19);
    }
    EXPECT_TRUE(has_shoulder);
    double first_mm = 0, last_mm = 0, first = 0, last = 0;
    for (std::size_t i = 0; i < skin.values.size(); ++i) {
        const SkinStation& station = skin.stations[i / columns];
        if (!station.isFace() || station.radius_mm > 12 || std::isnan(skin.values[i])) continue;
        (station.normal.x() < 0 ? first_mm : last_mm) += static_cast<double>(skin.values[i]);
        (station.normal.x() < 0 ? first : last) += 1;
    }
    ASSERT_GT(first, 0);
    ASSERT_GT(last, 0);
    EXPECT_NEAR(first_mm / first + last_mm / last, 0.2, 0.01);
}

TEST(DeviationSkin, TheSameBitsForAnyNumberOfThreads)
{
    const ShaftScans scans = shaftTwice(6, {.step_deg = 6.6});
    const CompareResult result = compare(scans.reference, scans.copy);
    const Skin all = deviationSkin(result);
    const ThreadLimit one(1);
    const Skin single = deviationSkin(result);
    ASSERT_EQ(all.vertexCount(), single.vertexCount());
    for (std::size_t i = 0; i < all.values.size(); ++i)
        EXPECT_TRUE(all.values[i] == single.values[i] || (std::isnan(all.values[i]) && std::isnan(single.values[i])));
    EXPECT_EQ(all.shift_mm, single.shift_mm);
}

TEST(DeviationSkin, IsEmptyWithoutAnAxis)
{
    const BoxScans box = boxTwice(1, 0.01, 1, 0, 0, true);
    EXPECT_TRUE(deviationSkin(compare(box.reference, box.copy)).stations.empty());
}

}  // namespace
}  // namespace lathelier::registration
