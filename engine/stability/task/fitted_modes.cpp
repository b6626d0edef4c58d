#include "engine/stability/task/fitted_modes.h"

#include "engine/stability/stability_codes.h"
#include "engine/stability/task/response_fit.h"

namespace lathelier::stability {

std::vector<Mode> fittedModes(const Frf& frf, const std::string& basis, Stores& stores, Notes& found,
                              const Progress& progress)
{
    const auto fit = fitOf(frf, basis, stores, progress);
    found.insert(found.end(), fit->notes.begin(), fit->notes.end());
    if (fit->modes.empty()) throw Error(errors::modesNeeded, {});
    std::vector<Mode> modes;
    modes.reserve(fit->modes.size());
    for (const receptance::FittedMode& fitted : fit->modes)
        modes.push_back({fitted.mode.frequency_hz, fitted.mode.damping_ratio, fitted.mode.stiffness_N_mm});
    found.push_back({notes::modesFitted,
                     {{"count", static_cast<std::int64_t>(modes.size())}, {"error_percent", fit->error_rms_percent}}});
    return modes;
}

}  // namespace lathelier::stability
