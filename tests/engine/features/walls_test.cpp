// Walls of the bins of a meridian, and their chains.
#include "engine/features/walls/walls.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"

namespace lathelier::features {
namespace {

constexpr double border_mm = 0.1;  // width of a bin

/// Rows of a cylinder of radius 9 mm, 0.15 mm apart: every second one would lie on the border of two bins. `split`: so
/// many points of these rows lie before it.
MeridianCloud rowsOnBorders(int split)
{
    constexpr int rows = 200, points = 300;
    MeridianCloud cloud;
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < points; ++i) {
            const double z = 0.15 * row + (row % 2 == 0 && i < split ? -0.002 : 0.002);
            cloud.z_mm.push_back(static_cast<float>(z));
            cloud.r_mm.push_back(static_cast<float>(
                9 + 0.03 * randomNormal(3, static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(i))));
            cloud.turn.push_back(static_cast<float>((i + 0.5) / points));
        }
    cloud.z_first_mm = -border_mm;
    cloud.z_last_mm = 0.15 * rows;
    cloud.points_per_mm = points / 0.15;
    return cloud;
}

TEST(Walls, RowsOnABorderOfBinsAreOneChain)
{
    for (const int split : {0, 6, 40, 150, 290}) {
        const Walls walls = findWalls(rowsOnBorders(split), border_mm, 0.03);
        ASSERT_EQ(walls.chains.size(), 1U) << split;
        const std::vector<Wall>& found = walls.chains.front().walls;
        EXPECT_NEAR(static_cast<double>(found.size()), 200, 2) << split;
        for (std::size_t i = 0; i + 1 < found.size(); ++i)
            EXPECT_GT(found[i + 1].z_mm - found[i].z_mm, 0.1) << split << " " << i;
        for (const Wall& wall : found) EXPECT_GT(wall.points, 280) << split << " z " << wall.z_mm;
    }
}

}  // namespace
}  // namespace lathelier::features
