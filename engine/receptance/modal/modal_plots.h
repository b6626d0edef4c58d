// Charts of a measured response with the computed one and the modal model, for screen and paper.
#pragma once

#include "engine/core/texts.h"
#include "engine/receptance/modal/response_study.h"
#include "engine/report/chart.h"

namespace lathelier::receptance {

/// Key of the handle on the peak of mode `index`.
std::string modeHandleKey(std::size_t index);

/// The mode of a handle's key; none for other keys.
std::optional<std::size_t> modeOfHandle(const std::string& key);

/// Magnitude, logarithmic; with labelled natural frequencies and a handle on each of the model's peaks.
report::Plot magnitudePlot(const ResponseStudy& study, bool with_handles, const Language& language = {});
report::Plot phasePlot(const ResponseStudy& study);
report::Plot realPlot(const ResponseStudy& study, const Language& language = {});
report::Plot imaginaryPlot(const ResponseStudy& study);

/// Imaginary over real part with equal scales; the frequency runs along.
report::Plot nyquistPlot(const ResponseStudy& study);

/// Coherence of the measured response; without curves where it is unknown.
report::Plot coherencePlot(const ResponseStudy& study);

/// Poles of linear fits over their order, by frequency, with the modes of the model as lines; without curves where
/// there is no fit.
report::Plot stabilisationPlot(const ResponseStudy& study, const Language& language = {});

/// Error of the model over the frequency.
report::Plot errorPlot(const ResponseStudy& study);

}  // namespace lathelier::receptance
