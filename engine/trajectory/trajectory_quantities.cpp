#include "engine/trajectory/trajectory_quantities.h"

#include <nlohmann/json.hpp>

#include "engine/core/units.h"
#include "engine/form/roundness/roundness_quantities.h"
#include "engine/trajectory/channel_map.h"

namespace lathelier::trajectory {
namespace {

using S = TrajectorySection;
using L = LongitudinalSection;

/// A quantity of the section's roundness under its key there, with another name and a heading where required.
QuantityOf<S> ofForm(const char* key, int decimals, Text label = {}, Text heading = {})
{
    const QuantityOf<form::RoundnessResult>& inner = quantityOf<form::RoundnessResult>(key);
    QuantityInfo info = inner.info;
    info.decimals = decimals;
    if (!label.empty()) info.label = label;
    info.heading = heading;
    return {info, [get = inner.get](const S& s) { return get(s.roundness); }};
}

template <Probe probe>
std::vector<double> meanOf(const S& section)
{
    return section.mean_um(probe);
}

/// The keys "error_motion.X3.…" and "drift_um_per_rev.X3", and so on for every probe.
std::vector<QuantityOf<S>> motions()
{
    std::vector<QuantityOf<S>> result;
    for (std::size_t probe = 0; probe < 4; ++probe) {
        const std::string which(name(static_cast<Probe>(probe)));
        for (const QuantityOf<ErrorMotion>& inner : quantities<ErrorMotion>())
            result.push_back({detail::within(inner.info, "error_motion." + which),
                              [probe, get = inner.get](const S& s) { return get(s.error_motion[probe]); }});
        result.push_back(
            {{"drift_um_per_rev." + which}, [probe](const S& s) -> Value { return s.drift_um_per_rev[probe]; }});
    }
    return result;
}

template <int axis>
std::vector<double> centres(const L& section)
{
    std::vector<double> result;
    for (const Eigen::Vector2d& centre : section.centre_um) result.push_back(centre[axis]);
    return result;
}

}  // namespace

const std::vector<QuantityOf<ErrorMotion>>& quantitiesOf(const ErrorMotion*)
{
    using M = ErrorMotion;
    static const auto all = describedBy<M>(
        quantity<M>("synchronous_um", &M::synchronous_um, {LT_TEXT("Engine", "Synchronous error motion"), unit::um, 2}),
        quantity<M>("asynchronous_um", &M::asynchronous_um,
                    {LT_TEXT("Engine", "Asynchronous error motion"), unit::um, 2}),
        quantity<M>("total_um", &M::total_um, {LT_TEXT("Engine", "Total error motion"), unit::um, 2}),
        quantity<M>("synchronous_expanded_uncertainty_um", &M::synchronous_expanded_uncertainty_um,
                    {LT_TEXT("Engine", "U of the synchronous error motion (k = 2)"), unit::um, 2}),
        quantity<M>("total_expanded_uncertainty_um", &M::total_expanded_uncertainty_um,
                    {LT_TEXT("Engine", "U of the total error motion (k = 2)"), unit::um, 2}));
    return all;
}

const std::vector<QuantityOf<TrajectorySection>>& quantitiesOf(const TrajectorySection*)
{
    static const auto all = describedBy<S>(
        quantity<S>("section", &S::section, {LT_TEXT("Engine", "Section"), {}, 0, true, LT_TEXT("Engine", "section")}),
        quantity<S>("record", &S::record),
        quantity<S>("z_mm", &S::z_mm,
                    {LT_TEXT("Engine", "From the free end"), unit::mm, 2, true, LT_TEXT("Engine", "z")}),
        quantity<S>("revolutions_found", &S::revolutions_found),
        quantity<S>("revolutions_used", &S::revolutions_used,
                    {LT_TEXT("Engine", "Revolutions"), {}, 0, true, LT_TEXT("Engine", "revolutions")}),
        quantity<S>("samples_rejected", &S::samples_rejected), quantity<S>("speed_rpm", &S::speed_rpm),
        quantity<S>("angle_deg", &S::angle_deg), quantity<S>("radius_mm", &S::radius_mm),
        quantity<S>("body_angle_deg", &S::body_angle_deg), quantity<S>("envelope_min_mm", &S::envelope_min_mm),
        quantity<S>("envelope_max_mm", &S::envelope_max_mm), quantity<S>("revolution_RONt_um", &S::revolution_RONt_um),
        quantity<S>("workpiece_axis.x_um", meanOf<Probe::X3>), quantity<S>("workpiece_axis.y_um", meanOf<Probe::Y3>),
        quantity<S>("tool.x_um", meanOf<Probe::Xp>), quantity<S>("tool.y_um", meanOf<Probe::Yp>),
        quantity<S>("diameter_mm", [](const S& s) { return 2 * s.roundness.circles.LSCI.radius_mm; },
                    {LT_TEXT("Engine", "Diameter (LSCI)"), unit::mm, 4, false, LT_TEXT("Engine", "diameter")}),
        quantity<S>("centre_x_um", [](const S& s) { return 1e3 * s.roundness.circles.LSCI.centre_mm.x(); },
                    {LT_TEXT("Engine", "centre x"), unit::um, 2, false}),
        quantity<S>("centre_y_um", [](const S& s) { return 1e3 * s.roundness.circles.LSCI.centre_mm.y(); },
                    {LT_TEXT("Engine", "centre y"), unit::um, 2, false}),
        quantity<S>("run_out_um", &S::run_out_um,
                    {LT_TEXT("Engine", "Radial run-out about the spindle axis (the paper's; not roundness)"), unit::um,
                     2, true, LT_TEXT("Engine", "run-out")}),
        quantity<S>("form_measured", &S::form_measured), ofForm("RONt_um", 2), ofForm("RONt_MZCI_um", 2, {}, {"MZCI"}),
        ofForm("RONt_LSCI_um", 2, {}, {"LSCI"}), ofForm("RONt_MICI_um", 2, {}, {"MICI"}),
        ofForm("RONt_MCCI_um", 2, {}, {"MCCI"}), ofForm("two_point.range_um", 2, {}, LT_TEXT("Engine", "two-point")),
        ofForm("two_point.half_range_um", 2, LT_TEXT("Engine", "Half of it, as GOST 24642-81 has it")),
        ofForm("RONt_expanded_uncertainty_um", 2), ofForm("tolerance_um", 3), ofForm("verdict", 0),
        quantity<S>("judged", [](const S& s) { return verdictName(s.roundness); },
                    {LT_TEXT("Engine", "verdict"), {}, 0, false}),
        part("spindle", &S::spindle), motions(), part("rotating", &S::rotating));
    return all;
}

const std::vector<QuantityOf<LongitudinalSection>>& quantitiesOf(const LongitudinalSection*)
{
    static const auto all = describedBy<L>(
        quantity<L>("taper_diameter_um", &L::taper_diameter_um,
                    {LT_TEXT("Engine", "Taper on diameter (+ grows from the free end)"), unit::um, 2}),
        quantity<L>("barrel_um", &L::barrel_um,
                    {LT_TEXT("Engine", "Barrel on radius (+ barrel, - saddle)"), unit::um, 2}),
        quantity<L>("diameter_range_um", &L::diameter_range_um,
                    {LT_TEXT("Engine", "Range of the diameters"), unit::um, 2}),
        quantity<L>("half_diameter_range_um", &L::half_diameter_range_um,
                    {LT_TEXT("Engine", "Half of it, as GOST 24642-81 has it"), unit::um, 2}),
        quantity<L>("axis_straightness_um", &L::axis_straightness_um,
                    {LT_TEXT("Engine", "Straightness of the axis"), unit::um, 2}),
        quantity<L>("profile_straightness_um", &L::profile_straightness_um,
                    {LT_TEXT("Engine", "Straightness of the profile (residual about its line)"), unit::um, 2}),
        quantity<L>("CYLt_LSCY_um", &L::CYLt_LSCY_um, {LT_TEXT("Engine", "Cylindricity CYLt(LSCY)"), unit::um, 2}),
        quantity<L>("CYLt_MZCY_um", &L::CYLt_MZCY_um,
                    {LT_TEXT("Engine", "Cylindricity CYLt(MZCY), locally optimal"), unit::um, 2}),
        quantity<L>("fit_mm", [](const L& l) { return std::vector<double>(l.fit_mm.begin(), l.fit_mm.end()); }),
        quantity<L>("z_mm", &L::z_mm), quantity<L>("radius_mm", &L::radius_mm), quantity<L>("centre.x_um", centres<0>),
        quantity<L>("centre.y_um", centres<1>));
    return all;
}

Json toJson(const TrajectoryResult& result)
{
    Json json{{"workpiece_diameter_mm", number(result.workpiece_diameter_mm)},
              {"mandrel_form_um", number(result.mandrel_form_um)}};
    const auto worst = result.worstSection();
    json["worst_section"] = worst ? Json(result.sections[*worst].section) : Json(nullptr);
    json["verdict"] = toJson(verdictKey(result));
    json["longitudinal"] = result.longitudinal ? nestedJson(describedValues(*result.longitudinal)) : Json(nullptr);
    json["cutting"] = toJson(result.cutting);
    json["sections"] = Json::array();
    for (const TrajectorySection& section : result.sections) {
        Json item = nestedJson(describedValues(section));
        item["circles"] = nestedJson(describedValues(section.roundness.circles));
        item["two_point"] = nestedJson(describedValues(section.roundness.two_point));
        item["harmonics"] = lathelier::toJson(Value(form::harmonicRows(section.roundness.harmonics)));
        json["sections"].push_back(std::move(item));
    }
    return json;
}

}  // namespace lathelier::trajectory
