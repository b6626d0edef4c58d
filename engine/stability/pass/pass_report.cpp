// Charts, report and JSON of lobes over a pass.
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/texts.h"
#include "engine/report/cells.h"
#include "engine/stability/pass/lobes_over_pass.h"

namespace lathelier::stability {
namespace {

const Text mm = LT_TEXT("Engine", "mm");

report::Axis speedAxis(const PassResult& result)
{
    report::Axis axis{LT_TEXT("Engine", "Spindle speed"), LT_TEXT("Engine", "1/min")};
    axis.range = Interval{result.speed_rpm.front(), result.speed_rpm.back()};
    return axis;
}

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

Json numbers(const std::vector<double>& values, std::size_t from, std::size_t count)
{
    Json list = Json::array();
    for (std::size_t i = from; i < from + count; ++i) list.push_back(number(values[i]));
    return list;
}

/// The speed whose least limit over the pass is highest.
std::size_t bestSpeed(const PassResult& result)
{
    std::size_t best = 0;
    const auto height = [&](std::size_t i) { return result.worst.k[i] < 0 ? HUGE_VAL : result.worst.depth_mm[i]; };
    for (std::size_t i = 1; i < result.speed_rpm.size(); ++i)
        if (height(i) > height(best)) best = i;
    return best;
}

}  // namespace

report::ColourMap passMap(const PassResult& result)
{
    report::ColourMap map;
    map.title = LT_TEXT("Engine", "Limit less depth of cut over the pass");
    map.x = speedAxis(result);
    map.y = {LT_TEXT("Engine", "Place of the tool z"), mm};
    map.value = {LT_TEXT("Engine", "Limit less depth of cut"), mm};
    const double first = result.stations.front().z_mm, last = result.stations.back().z_mm;
    const double half_z = (last - first) / static_cast<double>(result.stations.size() - 1) / 2;
    const double half_rpm =
        (result.speed_rpm.back() - result.speed_rpm.front()) / static_cast<double>(result.speed_rpm.size() - 1) / 2;
    map.x_from = result.speed_rpm.front() - half_rpm;
    map.x_to = result.speed_rpm.back() + half_rpm;
    map.y_from = first - half_z;
    map.y_to = last + half_z;
    map.columns = static_cast<int>(result.speed_rpm.size());
    map.rows = static_cast<int>(result.stations.size());
    const double depth_mm = *result.parameters.pass_depth_mm;
    map.limit = depth_mm;
    map.values.reserve(result.limit_mm.size());
    // Where no lobe limits, any depth is stable: the end of the scale.
    for (const double limit : result.limit_mm)
        map.values.push_back(static_cast<float>(std::isnan(limit) ? depth_mm : limit - depth_mm));
    return map;
}

report::Plot passPlot(const PassResult& result)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Least limit over the pass");
    plot.x = speedAxis(result);
    plot.y = {LT_TEXT("Engine", "Depth of cut"), mm};
    report::Curve curve{LT_TEXT("Engine", "least limit"), result.speed_rpm, result.worst.depth_mm};
    curve.colour = report::ColourRole::Limit;
    plot.curves = {std::move(curve)};
    plot.limits = {{report::Limit::Direction::Horizontal, *result.parameters.pass_depth_mm,
                    LT_TEXT("Engine", "depth of the pass")}};
    return plot;
}

report::Section passSection(const PassResult& result, const Language& language)
{
    const std::size_t best = bestSpeed(result);
    const double depth = result.worst.depth_mm[best];
    report::Paragraph words{
        LT_TEXT("Engine",
                "The shaft is thinner by the depth of cut behind the tool. Of all speeds shown {speed} 1/min bears the "
                "most over the whole pass: {depth} mm."),
        {{"speed", fixed(result.speed_rpm[best], 0, language)},
         {"depth", std::isnan(depth) ? std::string("∞") : fixed(depth, 3, language)}}};
    report::Table table{
        LT_TEXT("Engine", "Stations of the pass"),
        {LT_TEXT("Engine", "z (mm)"), LT_TEXT("Engine", "diameter left (mm)"), LT_TEXT("Engine", "least limit (mm)")},
        {},
        {1, 2, 3}};
    table.rows.reserve(result.stations.size());
    for (const PassStation& station : result.stations)
        table.rows.push_back(
            {station.z_mm, station.diameter_mm, station.minimum_mm ? Value(*station.minimum_mm) : Value()});
    return {LT_TEXT("Engine", "Lobes over the pass"),
            {std::move(words), passMap(result), passPlot(result), std::move(table)}};
}

Json passJson(const PassResult& result)
{
    Json json{{"z_mm", Json::array()}, {"diameter_mm", Json::array()}, {"minimum_depth_mm", Json::array()}};
    const std::size_t columns = result.speed_rpm.size();
    json["speed_rpm"] = result.speed_rpm;
    json["depth_mm"] = Json::array();
    for (std::size_t row = 0; row < result.stations.size(); ++row) {
        const PassStation& station = result.stations[row];
        json["z_mm"].push_back(station.z_mm);
        json["diameter_mm"].push_back(station.diameter_mm);
        json["minimum_depth_mm"].push_back(station.minimum_mm ? Json(*station.minimum_mm) : Json());
        json["depth_mm"].push_back(numbers(result.limit_mm, row * columns, columns));
    }
    json["worst"] = {{"depth_mm", numbers(result.worst.depth_mm, 0, columns)},
                     {"z_mm", numbers(result.worst_z_mm, 0, columns)},
                     {"frequency_hz", numbers(result.worst.frequency_hz, 0, columns)}};
    return json;
}

}  // namespace lathelier::stability
