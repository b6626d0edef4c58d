#include "engine/series/small_picture.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/statistics.h"
#include "engine/core/units.h"

namespace lathelier::series {
namespace {

constexpr std::size_t mostCells = 10000;
constexpr double shareWithinScale = 0.9;  // ends of the part are a column of 24 each
constexpr double leastLimit_mm = 1e-3;

std::optional<double> numberIn(const Json& json, const char* key)
{
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number()) return std::nullopt;
    return found->get<double>();
}

/// A count of a result that may come from elsewhere.
std::size_t countIn(const Json& json, const char* key)
{
    const std::optional<double> number = numberIn(json, key);
    return number && *number >= 1 && *number <= mostCells ? static_cast<std::size_t>(*number) : 0;
}

}  // namespace

std::optional<report::ColourMap> mapOf(const Json& result)
{
    const auto json = result.is_object() ? result.find("map") : result.end();
    if (!result.is_object() || json == result.end() || !json->is_object()) return std::nullopt;
    const auto start_mm = numberIn(*json, "z_start_mm"), step_mm = numberIn(*json, "z_step_mm");
    const std::size_t along = countIn(*json, "z_count"), about = countIn(*json, "angle_count");
    const auto means = json->find("mean_mm");
    if (!start_mm || !step_mm || !(*step_mm > 0) || along * about < 1 || along * about > mostCells) return std::nullopt;
    if (means == json->end() || !means->is_array() || means->size() != along * about) return std::nullopt;
    report::ColourMap map;
    map.x = {LT_TEXT("Engine", "z"), unit::mm};
    map.y = {LT_TEXT("Engine", "Angle"), unit::deg};
    map.value = {LT_TEXT("Engine", "Deviation"), unit::mm};
    map.x_from = *start_mm;
    map.x_to = *start_mm + static_cast<double>(along) * *step_mm;
    map.y_to = 360;
    map.columns = static_cast<int>(along);
    map.rows = static_cast<int>(about);
    map.values.resize(means->size());
    for (std::size_t z = 0; z < along; ++z)
        for (std::size_t angle = 0; angle < about; ++angle) {
            const Json& mean = (*means)[z * about + angle];
            map.values[angle * along + z] = mean.is_number() ? mean.get<float>() : static_cast<float>(notANumber);
        }
    return map;
}

void scaleAlike(std::vector<SmallPicture>& pictures)
{
    std::vector<float> sizes;
    for (const SmallPicture& picture : pictures)
        for (const float value : picture.map.values)
            if (!std::isnan(value)) sizes.push_back(std::abs(value));
    const double reach = sizes.empty() ? 0 : static_cast<double>(quantileInPlace(sizes, shareWithinScale));
    const double limit = report::niceLimit(std::max(reach, leastLimit_mm));
    for (SmallPicture& picture : pictures) picture.map.limit = limit;
}

}  // namespace lathelier::series
