#include "engine/receptance/modal/modal_quantities.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/units.h"
#include "engine/receptance/receptance_units.h"

namespace lathelier::receptance {
namespace {

constexpr double hundredth = 100;

Json residualsJson(const ModalResiduals& residuals, const ModalFit& fit)
{
    return {{"lower_mm_Ns2", residuals.lower_mm_Ns2},
            {"lower_uncertainty_mm_Ns2", fit.lower_uncertainty_mm_Ns2},
            {"upper_mm_N", residuals.upper_mm_N},
            {"upper_uncertainty_mm_N", fit.upper_uncertainty_mm_N}};
}

/// What one response has of its own: stiffnesses, whose signs are the shapes, and residuals.
Json commonJson(const CommonFit& one)
{
    Json json{{"response", one.name},
              {"error_rms_percent", one.fit->error_rms_percent},
              {"scatter_percent", one.fit->scatter_percent},
              {"residuals", residualsJson(one.fit->model.residuals, *one.fit)},
              {"modes", Json::array()}};
    for (const FittedMode& mode : one.fit->modes)
        json["modes"].push_back({{"frequency_hz", mode.mode.frequency_hz},
                                 {"stiffness_N_mm", mode.mode.stiffness_N_mm},
                                 {"stiffness_uncertainty_N_mm", mode.stiffness_uncertainty_N_mm},
                                 {"phase_deg", mode.mode.phase_deg}});
    return json;
}

std::optional<double> percent(const std::optional<double>& ratio)
{
    return ratio ? std::optional(hundredth * *ratio) : std::nullopt;
}

}  // namespace

const std::vector<QuantityOf<ShownMode>>& quantitiesOf(const ShownMode*)
{
    using M = ShownMode;
    static const auto all = describedBy<M>(
        quantity<M>("rank", &M::rank,
                    {LT_TEXT("Engine", "Rank by flexibility"), {}, 0, true, LT_TEXT("Engine", "Rank")}),
        quantity<M>("frequency_hz", [](const M& m) { return m.mode.frequency_hz; },
                    {LT_TEXT("Engine", "Natural frequency"), unit::hz, 2, true, LT_TEXT("Engine", "f")}),
        quantity<M>("frequency_uncertainty_hz", &M::frequency_uncertainty_hz,
                    {LT_TEXT("Engine", "Its standard uncertainty"), unit::hz, 3, true, LT_TEXT("Engine", "u(f)")}),
        quantity<M>("damping_ratio", [](const M& m) { return m.mode.damping_ratio; }),
        quantity<M>("damping_uncertainty", &M::damping_uncertainty),
        quantity<M>("damping_percent", [](const M& m) { return hundredth * m.mode.damping_ratio; },
                    {LT_TEXT("Engine", "Damping ratio ζ"), unit::percent, 3, false, LT_TEXT("Engine", "ζ")}),
        quantity<M>(
            "damping_uncertainty_percent", [](const M& m) { return percent(m.damping_uncertainty); },
            {LT_TEXT("Engine", "Its standard uncertainty"), unit::percent, 3, false, LT_TEXT("Engine", "u(ζ)")}),
        quantity<M>("stiffness_N_mm", [](const M& m) { return m.mode.stiffness_N_mm; },
                    {LT_TEXT("Engine", "Modal stiffness"), unit::N_mm, 0, true, LT_TEXT("Engine", "k")}),
        quantity<M>("stiffness_uncertainty_N_mm", &M::stiffness_uncertainty_N_mm,
                    {LT_TEXT("Engine", "Its standard uncertainty"), unit::N_mm, 1, true, LT_TEXT("Engine", "u(k)")}),
        quantity<M>("damping_stiffness_correlation", &M::damping_stiffness_correlation),
        quantity<M>("phase_deg", [](const M& m) { return m.mode.phase_deg; },
                    {LT_TEXT("Engine", "Phase of the residue"), unit::deg, 1, true, LT_TEXT("Engine", "phase")}),
        quantity<M>("flexibility_nm_N", &M::flexibility_nm_N,
                    {LT_TEXT("Engine", "Least real part of this mode, sign reversed"), LT_TEXT("Engine", "nm/N"), 1,
                     true, LT_TEXT("Engine", "-min Re")}));
    return all;
}

std::vector<ShownMode> shownModes(const ResponseStudy& study)
{
    std::vector<ShownMode> modes;
    modes.reserve(study.model.modes.size());
    for (std::size_t k = 0; k < study.model.modes.size(); ++k) {
        ShownMode& shown = modes.emplace_back();
        shown.mode = study.model.modes[k];
        shown.flexibility_nm_N = nm_per_mm * flexibilityOf(shown.mode);
        if (study.is_changed) continue;
        const FittedMode& fitted = study.fit->modes[k];
        shown.frequency_uncertainty_hz = fitted.frequency_uncertainty_hz;
        shown.damping_uncertainty = fitted.damping_uncertainty;
        shown.stiffness_uncertainty_N_mm = fitted.stiffness_uncertainty_N_mm;
        shown.damping_stiffness_correlation = fitted.damping_stiffness_correlation;
    }
    int rank = 0;
    for (const std::size_t k : byFlexibility(study.model.modes)) modes[k].rank = ++rank;
    return modes;
}

const std::vector<QuantityOf<OrderPole>>& quantitiesOf(const OrderPole*)
{
    using P = OrderPole;
    static const auto all =
        describedBy<P>(quantity<P>("order", &P::order), quantity<P>("frequency_hz", &P::frequency_hz),
                       quantity<P>("damping_ratio", &P::damping_ratio), quantity<P>("is_stable", &P::is_stable),
                       quantity<P>("is_damping_stable", &P::is_damping_stable));
    return all;
}

Json toJson(const ResponseStudy& study)
{
    Json json;
    json["lines"] = study.basis() ? Json(study.basis()->value.size()) : Json();
    if (!study.fit) return json;
    json["range_hz"] = {{"from", study.fit->range_hz.from}, {"to", study.fit->range_hz.to}};
    json["changed_by_hand"] = study.is_changed;
    json["error_rms_percent"] = study.error_rms_percent;
    json["scatter_percent"] = study.fit->scatter_percent;
    json["modes"] = Json::array();
    for (const ShownMode& mode : shownModes(study)) json["modes"].push_back(nestedJson(describedValues(mode)));
    json["residuals"] = residualsJson(study.model.residuals, *study.fit);
    json["stabilisation"] = Json::array();
    for (const OrderPole& pole : study.fit->orders) json["stabilisation"].push_back(nestedJson(describedValues(pole)));
    if (study.common.empty()) return json;
    json["responses"] = Json::array();
    for (const CommonFit& one : study.common) json["responses"].push_back(commonJson(one));
    return json;
}

}  // namespace lathelier::receptance
