#include "engine/stability/operating_point.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/units.h"

namespace lathelier::stability {

const std::vector<Field<PointParameters>>& fieldsOf(const PointParameters*)
{
    using P = PointParameters;
    static const std::vector<Field<P>> all{
        field("operating_speed_rpm", &P::operating_speed_rpm, Range{1, 1e6},
              Label{LT_TEXT("Engine", "Operating speed"),
                    LT_TEXT("Engine", "Of a point that is asked about: is it stable, and how surely?"), unit::rpm}),
        field("operating_depth", &P::operating_depth, Range{1e-6, 1e6},
              Label{LT_TEXT("Engine", "Operating depth of cut"),
                    LT_TEXT("Engine",
                            "Of that point, in mm; without a cutting coefficient in multiples of the least limit.")})};
    return all;
}

std::optional<OperatingPoint> operatingPointOf(const PointParameters& parameters)
{
    const auto& [speed_rpm, depth] = parameters;
    if (speed_rpm.has_value() != depth.has_value())
        throw Error(errors::valueNotUnderstood,
                    {{"parameter", speed_rpm ? "operating_depth" : "operating_speed_rpm"},
                     {"found", Value()},
                     {"expected", LT_TEXT("Engine", "speed and depth of the operating point")}});
    if (!speed_rpm) return std::nullopt;
    return OperatingPoint{*speed_rpm, *depth};
}

Json pointJson(const LobeResult& result, const OperatingPoint& point)
{
    const PointStability work = pointStabilityAt(result, point.speed_rpm, point.depth_mm);
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    return {{"speed_rpm", point.speed_rpm},
            {result.isRelative() ? "relative_depth" : "depth_mm", point.depth_mm},
            {result.isRelative() ? "relative_limit" : "limit_mm", number(work.limit_mm)},
            {"frequency_hz", number(work.frequency_hz)},
            {"k", work.k < 0 ? Json() : Json(work.k)},
            {"stable", work.stable},
            {"probability_stable", result.band ? Json(work.probability_stable) : Json()}};
}

report::QuantityTable pointTable(const LobeResult& result, const OperatingPoint& point)
{
    const PointStability work = pointStabilityAt(result, point.speed_rpm, point.depth_mm);
    const auto number = [](double value) { return std::isfinite(value) ? Value(value) : Value(); };
    const Text depth_unit = result.isRelative() ? Text{} : unit::mm;
    report::QuantityTable table{
        LT_TEXT("Engine", "Operating point"),
        {{LT_TEXT("Engine", "Spindle speed"), point.speed_rpm, unit::rpm, 0},
         {LT_TEXT("Engine", "Depth of cut"), point.depth_mm, depth_unit, 3},
         {LT_TEXT("Engine", "Limit at this speed"), number(work.limit_mm), depth_unit, 3},
         {LT_TEXT("Engine", "Chatter frequency at the limit"), number(work.frequency_hz), unit::hz, 1},
         {LT_TEXT("Engine", "Stable"), work.stable ? LT_TEXT("Engine", "yes") : LT_TEXT("Engine", "no"), Text{}}}};
    if (result.band)
        table.rows.push_back(
            {LT_TEXT("Engine", "Probability that it is stable"), 100 * work.probability_stable, unit::percent, 1});
    return table;
}

}  // namespace lathelier::stability
