#include "engine/form/roundness_json.h"

#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/form/circles_json.h"

namespace lathelier::form {
namespace {

Json toJson(const MethodRow& row)
{
    Json json{{"low_upr", number(row.band.low_upr)},
              {"high_upr", number(row.band.high_upr)},
              {"outliers", row.outliers == OutlierRule::Hampel ? "hampel" : "none"}};
    for (const ReferenceCircle circle :
         {ReferenceCircle::LSCI, ReferenceCircle::MZCI, ReferenceCircle::MICI, ReferenceCircle::MCCI})
        json["RONt_" + std::string(name(circle)) + "_um"] = number(row.RONt_um[static_cast<std::size_t>(circle)]);
    json["undersampled"] = row.undersampled;
    return json;
}

const char* key(signal::FilterWay way)
{
    switch (way) {
        case signal::FilterWay::Uniform: return "uniform";
        case signal::FilterWay::Series: return "series";
        case signal::FilterWay::Regression: return "regression";
    }
    return "";
}

}  // namespace

std::string_view key(DecisionRule rule)
{
    return rule == DecisionRule::Guarded ? "guarded" : "simple";
}

std::string_view key(FormVerdict verdict)
{
    switch (verdict) {
        case FormVerdict::Pass: return "pass";
        case FormVerdict::Fail: return "fail";
        case FormVerdict::Undecided: return "undecided";
    }
    return {};
}

Json toJson(const TwoPointSize& size)
{
    return {{"range_um", number(size.range_um)},
            {"half_range_um", number(size.half_range_um)},
            {"largest_mm", number(size.largest_mm)},
            {"smallest_mm", number(size.smallest_mm)},
            {"caliper_largest_mm", number(size.caliper_largest_mm)},
            {"caliper_smallest_mm", number(size.caliper_smallest_mm)}};
}

Json toJson(const std::vector<signal::Harmonic>& harmonics)
{
    Json json = Json::array();
    for (const signal::Harmonic& h : harmonics)
        json.push_back({{"upr", h.upr},
                        {"amplitude_um", number(h.amplitude)},
                        {"phase_deg", number(h.phase_rad * 180 / std::numbers::pi)}});
    return json;
}

Json toJson(const RoundnessResult& result)
{
    const signal::ProfileBand band = bandOf(result.parameters);
    Json json{{"name", result.name}, {"points", result.points}};
    json["points_used"] = result.evaluated_index.size();
    json["filter"] = {{"low_upr", number(band.low_upr)},
                      {"high_upr", number(band.high_upr)},
                      {"way", band.isAll() ? "none" : key(result.filter_way)}};
    json["circles"] = toJson(result.circles);
    json["two_point"] = toJson(result.two_point);
    json["harmonics"] = toJson(result.harmonics);
    json["RONt_um"] = number(headlineDeviation_um(result));
    json["reference_circle"] = name(result.parameters.circle);
    json["RONt_expanded_uncertainty_um"] = number(result.RONt_expanded_uncertainty_um);
    json["point_noise_um"] = number(result.point_noise_um);
    json["decision_rule"] = key(result.parameters.decision);
    json["verdict"] = result.verdict ? Json(key(*result.verdict)) : Json(nullptr);
    json["methods"] = Json::array();
    for (const MethodRow& row : result.methods) json["methods"].push_back(toJson(row));
    json["hints"] = Json::array();
    for (const RoundnessHint& hint : result.hints)
        json["hints"].push_back({{"upr", hint.upr},
                                 {"amplitude_um", number(hint.amplitude_um)},
                                 {"share_percent", number(hint.share_percent)},
                                 {"meaning", hint.meaning.english}});
    json["paper"] = {{"run_out_um", number(result.paper.run_out_um)},
                     {"limacon_centre_um", numbers(result.paper.limacon_centre_um)}};
    json["notes"] = toJson(result.notes);
    return json;
}

Json toJson(const SuperimposeResult& result)
{
    return {{"rotation_deg", number(result.rotation_deg)},
            {"mirrored", result.mirrored},
            {"shift_mm", numbers(result.shift_mm)},
            {"radius_difference_mm", number(result.radius_difference_mm)},
            {"largest_difference_um", number(result.largest_difference_um)},
            {"mean_difference_um", number(result.mean_difference_um)},
            {"rms_difference_um", number(result.rms_difference_um)},
            {"correlation", number(result.correlation)},
            {"angle_deg", numbers(result.angle_deg)},
            {"first_um", numbers(result.first_um)},
            {"second_um", numbers(result.second_um)},
            {"notes", toJson(result.notes)}};
}

}  // namespace lathelier::form
