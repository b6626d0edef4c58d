// Charts, report and JSON of lobes over a pass.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/report/cells.h"
#include "engine/report/parameters_table.h"
#include "engine/stability/depth_digits.h"
#include "engine/stability/envelope.h"
#include "engine/stability/pass/lobes_over_pass.h"
#include "engine/stability/stability_plots.h"
#include "engine/stability/stability_verification.h"

namespace lathelier::stability {
namespace {

report::Axis passSpeedAxis(const PassResult& result)
{
    report::Axis axis{LT_TEXT("Engine", "Spindle speed"), unit::rpm};
    axis.range = Interval{result.speed_rpm.front(), result.speed_rpm.back()};
    return axis;
}

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json();
}

Json numbersWithin(const std::vector<double>& values, std::size_t from, std::size_t count)
{
    Json list = Json::array();
    for (std::size_t i = from; i < from + count; ++i) list.push_back(number(values[i]));
    return list;
}

PassPoint pointOfColumn(const PassResult& result, std::size_t column)
{
    PassPoint point;
    point.speed_rpm = result.speed_rpm[column];
    if (result.worst.k[column] < 0) return point;
    point.limit_mm = result.worst.depth_mm[column];
    point.z_mm = result.worst_z_mm[column];
    point.frequency_hz = result.worst.frequency_hz[column];
    point.stable = *result.parameters.pass_depth_mm < point.limit_mm;
    return point;
}

}  // namespace

PassPoint pointOfPass(const PassResult& result, double speed_rpm)
{
    const auto after = std::lower_bound(result.speed_rpm.begin(), result.speed_rpm.end(), speed_rpm);
    auto column = static_cast<std::size_t>(after - result.speed_rpm.begin());
    if (column == result.speed_rpm.size()) --column;
    if (column > 0 && speed_rpm - result.speed_rpm[column - 1] < result.speed_rpm[column] - speed_rpm) --column;
    PassPoint point = pointOfColumn(result, column);
    const double between = depthAt(result.worst, speed_rpm);  // NaN next to a speed without a limit
    if (std::isnan(between)) return point;
    point.limit_mm = between;
    point.stable = *result.parameters.pass_depth_mm < between;
    return point;
}

SafeSpeed safeOverPass(const PassResult& result, const std::optional<double>& selected_rpm, const Interval& range_rpm)
{
    SafeSpeedQuestion question;
    question.depth = *result.parameters.pass_depth_mm;
    question.range_rpm = range_rpm;
    question.selected_rpm = selected_rpm.value_or(result.speed_rpm.front());
    SafeSpeed safe = safeSpeedOn(result.worst, question);
    if (selected_rpm) return safe;
    question.selected_rpm = safe.best.speed_rpm;
    return safeSpeedOn(result.worst, question);
}

report::ColourMap passMap(const PassResult& result)
{
    report::ColourMap map;
    map.title = LT_TEXT("Engine", "Depth of cut beyond the limit");
    map.x = passSpeedAxis(result);
    map.y = {LT_TEXT("Engine", "Place of the tool z"), unit::mm};
    map.value = {LT_TEXT("Engine", "Beyond the limit"), unit::mm};
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
    map.limit = report::niceLimit(depth_mm);
    map.values.reserve(result.limit_mm.size());
    // If no lobe limits, any depth is stable: end of the colour scale.
    for (const double limit : result.limit_mm)
        map.values.push_back(static_cast<float>(std::isnan(limit) ? -map.limit : depth_mm - limit));
    return map;
}

report::Plot passPlot(const PassResult& result, const SafeSpeed& safe)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Least limit over the pass");
    plot.x = passSpeedAxis(result);
    plot.y = {LT_TEXT("Engine", "Depth of cut"), unit::mm};
    report::Curve curve{LT_TEXT("Engine", "least limit"), result.speed_rpm, result.worst.depth_mm};
    curve.colour = report::ColourRole::Limit;
    plot.curves = {std::move(curve)};
    shadeStability(plot, result.speed_rpm, result.worst.depth_mm);
    // Scaled to include the limit of the best speed, bounded so that the depth of the pass remains visible.
    const double depth_mm = *result.parameters.pass_depth_mm;
    const double best_mm = safe.best.limit.value_or(HUGE_VAL);
    plot.y.range = Interval{0, std::clamp(1.2 * best_mm, 1.6 * depth_mm, 6 * depth_mm)};
    plot.limits = {{report::Limit::Direction::Horizontal, depth_mm, LT_TEXT("Engine", "depth of the pass")}};
    report::Handle handle;
    handle.key = operatingPointKey;
    handle.x = safe.question.selected_rpm;
    handle.y = depth_mm;
    handle.x_range = plot.x.range;
    plot.handles = {handle};
    return plot;
}

report::Table stationsTable(const PassResult& result)
{
    report::Table table{
        LT_TEXT("Engine", "Stations of the pass"),
        {LT_TEXT("Engine", "z (mm)"), LT_TEXT("Engine", "diameter left (mm)"), LT_TEXT("Engine", "least limit (mm)")},
        {},
        {1, 2, 3}};
    for (const PassStation& station : result.stations)
        if (station.minimum_mm) table.decimals[2] = std::max(table.decimals[2], depthDecimals(*station.minimum_mm));
    table.rows.reserve(result.stations.size());
    for (const PassStation& station : result.stations)
        table.rows.push_back(
            {station.z_mm, station.diameter_mm, station.minimum_mm ? Value(*station.minimum_mm) : Value()});
    return table;
}

report::Section passSection(const PassResult& result, const SafeSpeed& safe, const Language& language)
{
    report::Paragraph words{
        LT_TEXT("Engine",
                "The shaft is thinner by the depth of cut behind the tool. Of all speeds shown {speed} 1/min bears the "
                "most over the whole pass: {depth} mm."),
        {{"speed", fixed(safe.best.speed_rpm, 0, language)},
         {"depth",
          safe.best.limit ? fixed(*safe.best.limit, depthDecimals(*safe.best.limit), language) : std::string("∞")}}};
    return {LT_TEXT("Engine", "Lobes over the pass"),
            {std::move(words), passMap(result), passPlot(result, safe), stationsTable(result)}};
}

report::Answer passAnswer(const PassResult& result, const SafeSpeed& safe, const Language& language)
{
    const double speed_rpm = safe.question.selected_rpm;
    const PassPoint point = pointOfPass(result, speed_rpm);
    report::Answer answer;
    const bool is_limited = std::isfinite(point.limit_mm);
    answer.quantity =
        is_limited ? LT_TEXT("Engine", "Depth that is stable over the pass") : LT_TEXT("Engine", "Depth of the pass");
    answer.value = is_limited ? roundedDepth(point.limit_mm) : *result.parameters.pass_depth_mm;
    answer.unit = unit::mm;
    answer.decimals = depthDecimals(std::fmin(*result.parameters.pass_depth_mm, point.limit_mm));
    if (is_limited) answer.lower_limit = result.parameters.pass_depth_mm;
    answer.verdict = point.stable ? Verdict::Pass : Verdict::Fail;
    answer.verdict_words = point.stable ? LT_TEXT("Engine", "✓ stable") : LT_TEXT("Engine", "✗ chatter");
    answer.sentence = is_limited
                          ? LT_TEXT("Engine", "{speed} 1/min · least limit at z {z} mm, chatter at {frequency} Hz")
                          : LT_TEXT("Engine", "{speed} 1/min · no lobe limits here");
    answer.values = {{"speed", fixed(speed_rpm, 0, language)},
                     {"z", fixed(point.z_mm, 1, language)},
                     {"frequency", fixed(point.frequency_hz, 1, language)}};
    answer.findings = findingsOf(safe, false, "operating_speed_rpm");
    return answer;
}

report::Document passReport(const PassResult& result, const SafeSpeed& safe, const LobeParameters& lobes,
                            const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Stability over a pass");
    document.verification = {&stabilityVerification()};
    report::Section first{LT_TEXT("Engine", "Result"), {passAnswer(result, safe, language)}};
    if (!result.notes.empty()) first.blocks.push_back(result.notes);
    document.sections = {std::move(first), passSection(result, safe, language)};
    document.sections.push_back(
        {LT_TEXT("Engine", "Method and parameters"),
         {report::Paragraph{LT_TEXT("Engine",
                                    "At each station the shaft as it is then, on its spindle, "
                                    "gives the limit of regenerative chatter at the tool."),
                            {}},
          report::parametersTable(result.parameters, language), report::parametersTable(lobes, language)}});
    return document;
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
        json["depth_mm"].push_back(numbersWithin(result.limit_mm, row * columns, columns));
    }
    json["worst"] = {{"depth_mm", numbersWithin(result.worst.depth_mm, 0, columns)},
                     {"z_mm", numbersWithin(result.worst_z_mm, 0, columns)},
                     {"frequency_hz", numbersWithin(result.worst.frequency_hz, 0, columns)}};
    return json;
}

}  // namespace lathelier::stability
