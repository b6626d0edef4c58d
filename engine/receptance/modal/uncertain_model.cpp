#include "engine/receptance/modal/uncertain_model.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/item_numbers.h"

namespace lathelier::receptance {
namespace {

constexpr const char* modesKey = "model_modes";
constexpr const char* beyondKey = "model_beyond";
constexpr const char* uncertaintiesKey = "model_uncertainties";  ///< f, ζ, k and correlation of each mode
constexpr const char* termsKey = "model_terms";                  ///< range (two numbers, or none), 1/M, 1/K

constexpr double sure = 2;  ///< standard uncertainties that a residual term exceeds

Rows rowsOf(const std::vector<ModalMode>& modes)
{
    Rows rows;
    for (const ModalMode& mode : modes) rows.rows.push_back({toValues(mode)});
    return rows;
}

std::vector<ModalMode> modesOf(const Values& item, const char* key)
{
    std::vector<ModalMode> modes;
    const Value* const value = find(item, key);
    const Rows* const rows = value ? std::get_if<Rows>(value) : nullptr;
    if (!rows) return modes;
    for (const Row& row : rows->rows) modes.push_back(fromValues<ModalMode>(row.cells));
    return modes;
}

}  // namespace

UncertainModel uncertainModelOf(const ModalFit& fit)
{
    UncertainModel result;
    result.model = fit.model;
    result.range_hz = fit.range_hz;
    // A residual term that may as well be none would stand for a mode that nobody has seen.
    ModalResiduals& terms = result.model.residuals;
    if (std::abs(terms.lower_mm_Ns2) <= sure * fit.lower_uncertainty_mm_Ns2) terms.lower_mm_Ns2 = 0;
    if (std::abs(terms.upper_mm_N) <= sure * fit.upper_uncertainty_mm_N) terms.upper_mm_N = 0;
    for (const FittedMode& mode : fit.modes)
        result.own.push_back({mode.frequency_uncertainty_hz, mode.damping_uncertainty, mode.stiffness_uncertainty_N_mm,
                              mode.damping_stiffness_correlation});
    return result;
}

UncertainModel uncertainModelOf(const ResponseStudy& study)
{
    UncertainModel result = uncertainModelOf(*study.fit);
    result.model.modes = study.model.modes;
    if (study.is_changed) result.own.clear();
    return result;
}

void addModel(const UncertainModel& model, Values& item)
{
    set(item, modesKey, rowsOf(model.model.modes));
    set(item, beyondKey, rowsOf(model.model.beyond));
    std::vector<double> uncertainties;
    for (const ModeUncertainty& one : model.own)
        uncertainties.insert(uncertainties.end(),
                             {one.frequency_hz, one.damping_ratio, one.stiffness_N_mm, one.correlation});
    set(item, uncertaintiesKey, std::move(uncertainties));
    const ModalResiduals& terms = model.model.residuals;
    std::vector<double> numbers{terms.lower_mm_Ns2, terms.upper_mm_N};
    if (model.range_hz) numbers.insert(numbers.end(), {model.range_hz->from, model.range_hz->to});
    set(item, termsKey, std::move(numbers));
}

std::optional<UncertainModel> modelIn(const Values& item)
{
    UncertainModel result;
    try {
        result.model.modes = modesOf(item, modesKey);
        result.model.beyond = modesOf(item, beyondKey);
    } catch (const Error&) {
        return std::nullopt;
    }
    const auto terms = numbersIn(item, termsKey);
    if (result.model.modes.empty() || !terms || terms->size() < 2) return std::nullopt;
    result.model.residuals = {(*terms)[0], (*terms)[1]};
    if (terms->size() == 4 && (*terms)[2] > 0 && (*terms)[3] > (*terms)[2])
        result.range_hz = Interval{(*terms)[2], (*terms)[3]};
    const auto numbers = numbersIn(item, uncertaintiesKey);
    if (numbers && numbers->size() == 4 * result.model.modes.size())
        for (std::size_t i = 0; i < numbers->size(); i += 4)
            result.own.push_back({std::abs((*numbers)[i]), std::abs((*numbers)[i + 1]), std::abs((*numbers)[i + 2]),
                                  std::clamp((*numbers)[i + 3], -1.0, 1.0)});
    return result;
}

}  // namespace lathelier::receptance
