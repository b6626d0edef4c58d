#include "engine/series/small_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace lathelier::series {
namespace {

Json resultWithMap()
{
    return Json::parse(R"({"map": {"z_start_mm": 2, "z_step_mm": 3, "z_count": 2, "angle_count": 3,
                                   "mean_mm": [0.01, 0.02, null, 0.04, -0.05, 0.06]}})");
}

TEST(SmallPicture, has_z_across_and_the_angle_upwards)
{
    const auto map = mapOf(resultWithMap());
    ASSERT_TRUE(map);
    EXPECT_EQ(map->columns, 2);
    EXPECT_EQ(map->rows, 3);
    EXPECT_EQ(map->x_from, 2);
    EXPECT_EQ(map->x_to, 8);
    EXPECT_FLOAT_EQ(static_cast<float>(map->at(3, 60)), 0.01F);
    EXPECT_FLOAT_EQ(static_cast<float>(map->at(6, 180)), -0.05F);
    EXPECT_TRUE(std::isnan(map->at(3, 300)));
}

TEST(SmallPicture, a_result_without_a_sound_map_has_none)
{
    EXPECT_FALSE(mapOf(nullptr));
    EXPECT_FALSE(mapOf(Json::array()));
    EXPECT_FALSE(mapOf(Json::parse("{\"map\": null}")));
    for (const char* key : {"z_start_mm", "z_step_mm", "z_count", "angle_count", "mean_mm"}) {
        Json without = resultWithMap();
        without["map"].erase(key);
        EXPECT_FALSE(mapOf(without)) << key;
        Json odd = resultWithMap();
        odd["map"][key] = "many";
        EXPECT_FALSE(mapOf(odd)) << key;
        odd["map"][key] = -1;
        EXPECT_EQ(mapOf(odd).has_value(), std::string(key) == "z_start_mm") << key;
        odd["map"][key] = 1e300;
        EXPECT_EQ(mapOf(odd).has_value(), std::string(key).ends_with("_mm") && std::string(key) != "mean_mm") << key;
    }
}

TEST(SmallPicture, all_have_one_readable_scale)
{
    std::vector<SmallPicture> pictures(3);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        pictures[i].map.columns = 10;
        pictures[i].map.rows = 10;
        pictures[i].map.values.assign(100, 0.01F * static_cast<float>(i + 1));
    }
    pictures[0].map.values[5] = 9;  // one cell does not choose the scale
    pictures[0].map.values[6] = NAN;
    scaleAlike(pictures);
    for (const SmallPicture& picture : pictures) EXPECT_DOUBLE_EQ(picture.map.limit, 0.03);
    std::vector<SmallPicture> none;
    scaleAlike(none);
    EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace lathelier::series
