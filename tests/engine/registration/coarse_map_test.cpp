#include "engine/registration/coarse_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lathelier::registration {
namespace {

UnrolledMap mapOf(int rows, int columns)
{
    UnrolledMap map;
    map.z_start_mm = 5;
    map.z_step_mm = 0.5;
    map.z_count = rows;
    map.angle_count = columns;
    map.mean_mm.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), 0.01F);
    return map;
}

TEST(CoarseMap, has_few_cells_that_cover_the_whole_map)
{
    for (const int rows : {1, 23, 24, 25, 100, 401})
        for (const int columns : {1, 7, 36, 72, 90, 360}) {
            SCOPED_TRACE(std::to_string(rows) + " " + std::to_string(columns));
            const CoarseMap coarse = coarseOf(mapOf(rows, columns));
            EXPECT_LE(coarse.z_count, coarseRows);
            EXPECT_LE(coarse.angle_count, coarseColumns);
            EXPECT_EQ(columns % coarse.angle_count, 0);
            EXPECT_GE(coarse.z_count * coarse.z_step_mm, rows * 0.5);
            EXPECT_LT((coarse.z_count - 1) * coarse.z_step_mm, rows * 0.5);
            for (const double mean : coarse.mean_mm) EXPECT_EQ(mean, 0.01);
        }
}

TEST(CoarseMap, cell_is_the_mean_of_those_that_have_points)
{
    UnrolledMap map = mapOf(48, 72);  // cells of 2 × 2
    map.mean_mm[0] = 0.02F;
    map.mean_mm[1] = std::numeric_limits<float>::quiet_NaN();
    for (const std::size_t cell : {std::size_t{2}, std::size_t{3}, std::size_t{74}, std::size_t{75}})
        map.mean_mm[cell] = std::numeric_limits<float>::quiet_NaN();
    const CoarseMap coarse = coarseOf(map);
    EXPECT_EQ(coarse.mean_mm[0], 0.0133);
    EXPECT_TRUE(std::isnan(coarse.mean_mm[1]));
}

TEST(CoarseMap, empty_map_stays_empty)
{
    EXPECT_TRUE(coarseOf(UnrolledMap()).mean_mm.empty());
}

}  // namespace
}  // namespace lathelier::registration
