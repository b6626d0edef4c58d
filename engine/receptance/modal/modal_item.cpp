#include "engine/receptance/modal/modal_item.h"

#include <cmath>

namespace lathelier::receptance {
namespace {

constexpr const char* modesName = "modes";

/// Number under `name`; NaN without.
double numberIn(const Values& cells, const char* name)
{
    const Value* const found = find(cells, name);
    if (!found) return std::nan("");
    if (const auto* number = std::get_if<double>(found)) return *number;
    if (const auto* whole = std::get_if<std::int64_t>(found)) return static_cast<double>(*whole);
    return std::nan("");
}

}  // namespace

void addModes(Values& values, const std::vector<FittedMode>& modes)
{
    Rows rows;
    for (const FittedMode& one : modes)
        rows.rows.push_back({{{"frequency_hz", one.mode.frequency_hz},
                              {"damping_ratio", one.mode.damping_ratio},
                              {"stiffness_N_mm", one.mode.stiffness_N_mm},
                              {"phase_deg", one.mode.phase_deg},
                              {"frequency_uncertainty_hz", one.frequency_uncertainty_hz},
                              {"damping_uncertainty", one.damping_uncertainty},
                              {"stiffness_uncertainty_N_mm", one.stiffness_uncertainty_N_mm},
                              {"damping_stiffness_correlation", one.damping_stiffness_correlation},
                              {"half_power_lines", one.half_power_lines}}});
    set(values, modesName, std::move(rows));
}

std::vector<FittedMode> modesOf(const Values& values)
{
    const Value* const found = find(values, modesName);
    const auto* const rows = found ? std::get_if<Rows>(found) : nullptr;
    std::vector<FittedMode> modes;
    if (!rows) return modes;
    for (const Row& row : rows->rows) {
        const auto number = [&row](const char* name) { return numberIn(row.cells, name); };
        FittedMode one;
        one.mode = {number("frequency_hz"), number("damping_ratio"), number("stiffness_N_mm"), number("phase_deg")};
        one.frequency_uncertainty_hz = number("frequency_uncertainty_hz");
        one.damping_uncertainty = number("damping_uncertainty");
        one.stiffness_uncertainty_N_mm = number("stiffness_uncertainty_N_mm");
        one.damping_stiffness_correlation = number("damping_stiffness_correlation");
        one.half_power_lines = number("half_power_lines");
        const bool is_mode = one.mode.frequency_hz > 0 && one.mode.damping_ratio > 0 &&
                             std::abs(one.mode.stiffness_N_mm) > 0 && std::isfinite(one.mode.phase_deg) &&
                             one.frequency_uncertainty_hz >= 0 && one.damping_uncertainty >= 0 &&
                             one.stiffness_uncertainty_N_mm >= 0 && std::abs(one.damping_stiffness_correlation) <= 1 &&
                             one.half_power_lines >= 0;
        if (!is_mode) return {};
        one.flexibility_mm_N = flexibilityOf(one.mode);
        modes.push_back(one);
    }
    return modes;
}

}  // namespace lathelier::receptance
