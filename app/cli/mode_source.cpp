#include "app/cli/mode_source.h"

#include "app/cli/frf_source.h"
#include "engine/receptance/modal/modal_fit.h"
#include "engine/stability/stability_codes.h"

namespace lathelier::cli {

ModeSource modeSource(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const auto asked = fromValues<SourceParameters>(request.parameters);
    checkOneSource(request, asked);
    if (!asked.mode.empty()) return {asked.mode, {}};
    FrfSource source = frfSource(request, stability::usualHighestSpeed_rpm, inputs, progress.part(0, 0.4), answer);
    const receptance::ModalFit fit =
        receptance::fitModes(source.frf, {}, progress.part(0.4, 1, LT_TEXT("Engine", "Fitting modes")));
    answer.notes.insert(answer.notes.end(), fit.notes.begin(), fit.notes.end());
    if (fit.modes.empty()) throw Error(errors::modesNeeded, {});
    ModeSource found{{}, std::move(source.used)};
    for (const receptance::FittedMode& fitted : fit.modes)
        found.modes.push_back({fitted.mode.frequency_hz, fitted.mode.damping_ratio, fitted.mode.stiffness_N_mm});
    answer.notes.push_back(
        {notes::modesFitted,
         {{"count", static_cast<std::int64_t>(found.modes.size())}, {"error_percent", fit.error_rms_percent}}});
    return found;
}

}  // namespace lathelier::cli
