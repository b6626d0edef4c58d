#include "engine/receptance/modal/modal_notes.h"

#include <algorithm>
#include <cmath>

#include "engine/receptance/modal/modal_codes.h"

namespace lathelier::receptance {
namespace {

constexpr double resolvedLines = 4;  ///< least number of lines in a half-power band of a resolved mode
constexpr double uncertain = 0.3;    ///< relative standard uncertainty of a stiffness reported as large
constexpr double muchMore = 2.5, leastScatter_percent = 1;  ///< error over scatter that is said

/// Two digits.
double significant(double percent)
{
    if (!(percent > 0)) return 0;
    const double unit = std::pow(10, std::floor(std::log10(percent)) - 1);
    return percent >= 10 ? std::round(percent) : std::round(percent / unit) * unit;
}

}  // namespace

bool leavesMore(const ModalFit& fit)
{
    return fit.error_rms_percent > muchMore * std::max(fit.scatter_percent, leastScatter_percent);
}

void noteComplexModes(ModalFit& fit, double real_error_percent)
{
    fit.notes.push_back(
        {notes::complexModes,
         {{"real_percent", significant(real_error_percent)}, {"error_percent", significant(fit.error_rms_percent)}}});
}

void addNotes(ModalFit& fit, bool converged)
{
    Notes& notes = fit.notes;
    const auto count = static_cast<int>(fit.modes.size());
    if (fit.parameters.modes > count && count > 0)
        notes.push_back({notes::fewerModes,
                         {{"asked", std::int64_t{fit.parameters.modes}},
                          {"found", std::int64_t{count}},
                          {"from_hz", fit.range_hz.from},
                          {"to_hz", fit.range_hz.to}}});
    if (count == 0) notes.push_back({notes::noModes, {{"from_hz", fit.range_hz.from}, {"to_hz", fit.range_hz.to}}});
    const auto rounded = [](double value) { return std::round(100 * value) / 100; };
    for (const FittedMode& found : fit.modes) {
        const double f = rounded(found.mode.frequency_hz);
        if (found.half_power_lines < resolvedLines)
            notes.push_back({notes::modeNotResolved,
                             {{"frequency_hz", f},
                              {"lines", rounded(found.half_power_lines)},
                              {"minimum", static_cast<std::int64_t>(resolvedLines)}}});
        if (found.mode.stiffness_N_mm < 0) notes.push_back({notes::modeOutOfPhase, {{"frequency_hz", f}}});
        const double share = found.stiffness_uncertainty_N_mm / std::abs(found.mode.stiffness_N_mm);
        if (share > uncertain)
            notes.push_back({notes::modeUncertain, {{"frequency_hz", f}, {"percent", std::round(100 * share)}}});
    }
    for (const ModalMode& mode : fit.model.beyond)
        notes.push_back({notes::modesBeyond, {{"frequency_hz", rounded(mode.frequency_hz)}}});
    if (leavesMore(fit))
        notes.push_back({notes::fitLeavesMore,
                         {{"error_percent", significant(fit.error_rms_percent)},
                          {"scatter_percent", significant(fit.scatter_percent)}}});
    if (!converged) notes.push_back({notes::fitNotConverged, {}});
}

}  // namespace lathelier::receptance
