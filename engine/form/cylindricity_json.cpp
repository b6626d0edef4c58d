#include "engine/form/cylindricity_json.h"

#include <nlohmann/json.hpp>

#include "engine/form/roundness_json.h"

namespace lathelier::form {
namespace {

Json commonKeys(const FittedCylinder& cylinder)
{
    return {{"axis_point_mm", numbers(cylinder.axis_point_mm)},
            {"axis_direction", numbers(cylinder.axis_direction)},
            {"radius_mm", number(cylinder.radius_mm)},
            {"inner_radius_mm", number(cylinder.inner_radius_mm)},
            {"outer_radius_mm", number(cylinder.outer_radius_mm)},
            {"CYLt_um", number(cylinder.CYLt_um)}};
}

}  // namespace

Json toJson(const CylindricityResult& result)
{
    Json json;
    json["points"] = result.points;
    json["LSCY"] = commonKeys(result.LSCY);
    json["LSCY"]["CYLp_um"] = number(result.LSCY.CYLp_um);
    json["LSCY"]["CYLv_um"] = number(result.LSCY.CYLv_um);
    json["LSCY"]["CYLq_um"] = number(result.LSCY.CYLq_um);
    json["MZCY"] = commonKeys(result.MZCY);
    json["MZCY"]["contacts"] = result.MZCY.contacts;
    json["MZCY"]["optimum"] = "local";
    json["length_mm"] = number(result.length_mm);
    json["sections"] = result.sections;
    json["axis_straightness_um"] = number(result.axis_straightness_um);
    json["CYLt_expanded_uncertainty_um"] = number(result.CYLt_expanded_uncertainty_um);
    json["decision_rule"] = key(result.parameters.decision);
    json["verdict"] = result.verdict ? Json(key(*result.verdict)) : Json(nullptr);
    return json;
}

}  // namespace lathelier::form
