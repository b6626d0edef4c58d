#include "engine/trajectory/trajectory_json.h"

#include <nlohmann/json.hpp>

#include "engine/form/circles_json.h"
#include "engine/form/roundness_json.h"
#include "engine/trajectory/channel_map.h"

namespace lathelier::trajectory {
namespace {

Json verdict(const std::optional<form::FormVerdict>& value)
{
    return value ? Json(key(*value)) : Json(nullptr);
}

Json motion(const ErrorMotion& error)
{
    return {{"synchronous_um", number(error.synchronous_um)},
            {"asynchronous_um", number(error.asynchronous_um)},
            {"total_um", number(error.total_um)}};
}

Json pair(const TrajectorySection& section, Probe x, Probe y)
{
    return {{"x_um", numbers(section.probes[static_cast<std::size_t>(x)].mean_um)},
            {"y_um", numbers(section.probes[static_cast<std::size_t>(y)].mean_um)}};
}

Json toJson(const TrajectorySection& section)
{
    Json json{{"section", section.section}, {"record", section.record}, {"z_mm", number(section.z_mm)}};
    json["revolutions_found"] = section.revolutions_found;
    json["revolutions_used"] = section.revolutions_used;
    json["samples_rejected"] = section.samples_rejected;
    json["speed_rpm"] = number(section.speed_rpm);
    json["angle_deg"] = numbers(section.angle_deg);
    json["radius_mm"] = numbers(section.radius_mm);
    json["body_angle_deg"] = numbers(section.body_angle_deg);
    json["envelope_min_mm"] = numbers(section.envelope_min_mm);
    json["envelope_max_mm"] = numbers(section.envelope_max_mm);
    json["revolution_RONt_um"] = numbers(section.revolution_RONt_um);
    json["workpiece_axis"] = pair(section, Probe::X3, Probe::Y3);
    json["tool"] = pair(section, Probe::Xp, Probe::Yp);
    json["run_out_um"] = number(section.run_out_um);
    json["circles"] = toJson(section.roundness.circles);
    json["two_point"] = toJson(section.roundness.two_point);
    json["harmonics"] = form::toJson(section.roundness.harmonics);
    json["RONt_um"] = number(headlineDeviation_um(section.roundness));
    json["RONt_expanded_uncertainty_um"] = number(section.roundness.RONt_expanded_uncertainty_um);
    json["form_measured"] = section.form_measured;
    json["verdict"] = verdict(section.roundness.verdict);
    json["spindle"] = motion(section.spindle);
    for (std::size_t probe = 0; probe < section.error_motion.size(); ++probe) {
        json["error_motion"][name(static_cast<Probe>(probe))] = motion(section.error_motion[probe]);
        json["drift_um_per_rev"][name(static_cast<Probe>(probe))] = number(section.drift_um_per_rev[probe]);
    }
    json["rotating"] = section.rotating ? motion(*section.rotating) : Json(nullptr);
    return json;
}

Json toJson(const LongitudinalSection& section)
{
    Json x_um = Json::array(), y_um = Json::array();
    for (const Eigen::Vector2d& centre : section.centre_um) {
        x_um.push_back(number(centre.x()));
        y_um.push_back(number(centre.y()));
    }
    return {{"taper_diameter_um", number(section.taper_diameter_um)},
            {"barrel_um", number(section.barrel_um)},
            {"diameter_range_um", number(section.diameter_range_um)},
            {"half_diameter_range_um", number(section.half_diameter_range_um)},
            {"axis_straightness_um", number(section.axis_straightness_um)},
            {"profile_straightness_um", number(section.profile_straightness_um)},
            {"CYLt_LSCY_um", number(section.CYLt_LSCY_um)},
            {"CYLt_MZCY_um", number(section.CYLt_MZCY_um)},
            {"fit_mm", {number(section.fit_mm[0]), number(section.fit_mm[1]), number(section.fit_mm[2])}},
            {"z_mm", numbers(section.z_mm)},
            {"radius_mm", numbers(section.radius_mm)},
            {"centre", {{"x_um", x_um}, {"y_um", y_um}}}};
}

}  // namespace

Json toJson(const TrajectoryResult& result)
{
    Json json{{"workpiece_diameter_mm", number(result.workpiece_diameter_mm)},
              {"mandrel_form_um", number(result.mandrel_form_um)}};
    const auto worst = result.worstSection();
    json["worst_section"] = worst ? Json(result.sections[*worst].section) : Json(nullptr);
    json["verdict"] = verdict(result.verdict);
    json["longitudinal"] = result.longitudinal ? toJson(*result.longitudinal) : Json(nullptr);
    json["cutting"] = toJson(result.cutting);
    json["sections"] = Json::array();
    for (const TrajectorySection& section : result.sections) json["sections"].push_back(toJson(section));
    return json;
}

}  // namespace lathelier::trajectory
