#include "engine/stability/stability_quantities.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/units.h"

namespace lathelier::stability {
namespace {

Json numbers(const std::vector<double>& values)
{
    Json list = Json::array();
    for (const double value : values) list.push_back(std::isfinite(value) ? Json(value) : Json());
    return list;
}

}  // namespace

const std::vector<QuantityOf<SpeedCandidate>>& quantitiesOf(const SpeedCandidate*)
{
    using C = SpeedCandidate;
    static const auto all =
        describedBy<C>(quantity<C>("k", &C::k, {LT_TEXT("Engine", "Lobe"), {}, 0}),
                       quantity<C>("speed_rpm", &C::speed_rpm, {LT_TEXT("Engine", "Stable speed"), unit::rpm, 0}),
                       quantity<C>("in_range", &C::in_range, {LT_TEXT("Engine", "In the tool's range"), {}, 0}));
    return all;
}

const std::vector<QuantityOf<SpeedResult>>& quantitiesOf(const SpeedResult*)
{
    using R = SpeedResult;
    static const auto all = describedBy<R>(
        quantity<R>("frequency_hz", &R::frequency_hz,
                    {LT_TEXT("Engine", "Frequency of the least real part"), unit::hz, 2}),
        quantity<R>("selected_rpm", &R::selected_rpm, {LT_TEXT("Engine", "Selected speed"), unit::rpm, 1}),
        quantity<R>("recommended_rpm", &R::recommended_rpm, {LT_TEXT("Engine", "Recommended speed"), unit::rpm, 1}),
        quantity<R>("recommended_cutting_speed_m_min", &R::recommended_cutting_speed_m_min,
                    {LT_TEXT("Engine", "Its cutting speed"), unit::m_min, 1}),
        quantity<R>("lobe.k", &R::k, {LT_TEXT("Engine", "Lobe of the selected speed"), {}, 0}),
        quantity<R>("lobe.low_rpm", [](const R& r) { return r.lobe_rpm.from; },
                    {LT_TEXT("Engine", "Its lower end"), unit::rpm, 1}),
        quantity<R>("lobe.high_rpm", [](const R& r) { return r.lobe_rpm.to; },
                    {LT_TEXT("Engine", "Its upper end"), unit::rpm, 1}),
        quantity<R>("candidates", [](const R& r) { return listed(r.candidates); }));
    return all;
}

const std::vector<QuantityOf<LobeResult>>& quantitiesOf(const LobeResult*)
{
    using R = LobeResult;
    static const auto all = describedBy<R>(
        quantity<R>("relation",
                    [](const R& r) { return r.parameters.relation == SpeedRelation::Exact ? "exact" : "published"; }),
        quantity<R>("minimum_depth_mm", [](const R& r) { return r.isRelative() ? std::nullopt : r.minimum_depth_mm; },
                    {LT_TEXT("Engine", "Least limiting depth"), unit::mm, 4}),
        quantity<R>("frequency_of_minimum_hz", &R::frequency_of_minimum_hz,
                    {LT_TEXT("Engine", "Its chatter frequency"), unit::hz, 2}),
        quantity<R>("minimum_noise_percent", &R::minimum_noise_percent,
                    {LT_TEXT("Engine", "Noise of its line"), unit::percent, 1}));
    return all;
}

Json toJson(const LobeResult& result)
{
    Json json = nestedJson(describedValues(result));
    const char* const depth = result.isRelative() ? "relative_depth" : "depth_mm";
    json["limit"] = {{"speed_rpm", numbers(result.limit.speed_rpm)},
                     {depth, numbers(result.limit.depth_mm)},
                     {"frequency_hz", numbers(result.limit.frequency_hz)}};
    json["lobes"] = Json::array();
    for (const Lobe& lobe : result.lobes)
        json["lobes"].push_back({{"k", lobe.k},
                                 {"speed_rpm", numbers(lobe.speed_rpm)},
                                 {depth, numbers(lobe.depth_mm)},
                                 {"frequency_hz", numbers(lobe.frequency_hz)}});
    if (result.band)
        json["band"] = {{"probability_percent", 95},
                        {result.isRelative() ? "low" : "low_mm", numbers(result.band->low_mm)},
                        {result.isRelative() ? "high" : "high_mm", numbers(result.band->high_mm)}};
    return json;
}

}  // namespace lathelier::stability
