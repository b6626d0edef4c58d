#include "engine/registration/compare_json.h"

#include <nlohmann/json.hpp>

namespace lathelier::registration {
namespace {

const char* keyOf(CompareMethod method)
{
    switch (method) {
        case CompareMethod::Auto: return "auto";
        case CompareMethod::Revolution: return "revolution";
        case CompareMethod::Plane: return "plane";
        case CompareMethod::Point: return "point";
    }
    return "";
}

Json verdictJson(const std::optional<Verdict>& verdict)
{
    return verdict ? Json(key(*verdict)) : Json(nullptr);
}

}  // namespace

Json toJson(const CompareResult& result)
{
    const Alignment& alignment = result.alignment;
    const DeviationStatistics& s = result.statistics;
    const auto withSign = [&](double value) { return result.has_sign ? number(value) : Json(nullptr); };

    Json json;
    json["method_used"] = keyOf(result.method_used);
    Json transform = Json::array();
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) transform.push_back(number(alignment.reference_T_copy.matrix()(r, c)));
    json["transform_reference_from_copy"] = transform;
    json["converged"] = alignment.converged;
    json["iterations"] = alignment.iterations;
    json["overlap_percent"] = number(s.overlap_percent);
    json["points_used"] = s.points_used;
    json["points_excluded"] = s.points_excluded;
    json["rmse_mm"] = withSign(s.rmse_mm);
    json["mean_mm"] = withSign(s.mean_mm);
    json["std_mm"] = withSign(s.std_mm);
    json["min_mm"] = withSign(s.min_mm);
    json["max_mm"] = withSign(s.max_mm);
    json["p95_abs_mm"] = withSign(s.p95_abs_mm);
    json["median_mm"] = withSign(s.median_mm);
    json["mad_sigma_mm"] = withSign(s.mad_sigma_mm);
    json["p2_5_mm"] = withSign(s.p2_5_mm);
    json["p97_5_mm"] = withSign(s.p97_5_mm);
    json["within_tolerance_percent"] = number(result.within_tolerance_percent);
    json["scatter_mm"] = number(result.scatter_mm);
    json["verdict_rule"] = key(result.parameters.verdict_rule);
    json["decision_rule"] = key(result.parameters.decision);
    json["verdict"] = verdictJson(result.verdict);
    json["worst"] = nullptr;
    if (const auto& worst = result.worst)
        json["worst"] = {{"z_mm", number(worst->z_mm)},
                         {"point_mm", numbers(worst->point_mm)},
                         {"angle_deg", number(worst->angle_deg)},
                         {"deviation_mm", number(worst->deviation_mm)},
                         {"uncertainty_mm", number(worst->uncertainty_mm)},
                         {"cell_mm", number(worst->cell_mm)}};
    json["findings"] = Json::array();
    for (const Finding& finding : result.findings)
        json["findings"].push_back({{"kind", key(finding.kind)},
                                    {"z_start_mm", number(finding.z_start_mm)},
                                    {"z_end_mm", number(finding.z_end_mm)},
                                    {"value_mm", number(finding.value_mm)},
                                    {"uncertainty_mm", number(finding.uncertainty_mm)},
                                    {"limit_mm", number(finding.limit_mm)},
                                    {"verdict", verdictJson(finding.verdict)}});
    json["distinguishable_from_scanner"] =
        result.distinguishable_from_scanner ? Json(*result.distinguishable_from_scanner) : Json(nullptr);
    json["cloud_to_cloud_rmse_mm"] = number(result.cloud_to_cloud_rmse_mm);
    json["cloud_to_cloud_rmse_standard_error_mm"] = number(result.cloud_to_cloud_rmse_error_mm);
    json["sampling_floor_mm"] = number(result.sampling_floor_mm);
    json["axis"] = nullptr;
    if (const auto& axis = alignment.reference_axis)
        json["axis"] = {{"point_mm", numbers(axis->point_mm)}, {"direction", numbers(axis->direction)}};
    json["zones"] = Json::array();
    for (const Zone& zone : result.zones) {
        Json one{{"name", zone.name.empty() ? Json(nullptr) : Json(zone.name)},
                 {"z_start_mm", number(zone.z_start_mm)},
                 {"z_end_mm", number(zone.z_end_mm)},
                 {"mean_mm", number(zone.mean_mm)},
                 {"std_mm", number(zone.std_mm)},
                 {"points", zone.points},
                 {"uncertainty_mm", number(zone.uncertainty_mm)},
                 {"verdict", verdictJson(zone.verdict)}};
        if (zone.lower_mm) one["lower_mm"] = number(zone.lower_mm);
        if (zone.upper_mm) one["upper_mm"] = number(zone.upper_mm);
        json["zones"].push_back(std::move(one));
    }
    json["free_motions"] = Json::array();
    for (const FreeMotion& motion : alignment.free_motions)
        json["free_motions"].push_back(
            {{"kind", motion.kind == FreeMotion::Kind::Rotation ? "rotation" : "translation"},
             {"direction", numbers(motion.direction)},
             {"point_mm", numbers(motion.point_mm)}});
    json["uncertainty"] = {{"axial_um", number(alignment.uncertainty.axial_um)},
                           {"radial_um", number(alignment.uncertainty.radial_um)},
                           {"axis_deg", number(alignment.uncertainty.axis_deg)}};
    json["histogram"] = {{"edges_mm", numbers(result.histogram.edges_mm)}, {"counts", result.histogram.counts}};
    return json;
}

}  // namespace lathelier::registration
