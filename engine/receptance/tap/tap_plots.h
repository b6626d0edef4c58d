// An impact test as charts, for screen and paper.
#pragma once

#include "engine/receptance/tap/tap_study.h"
#include "engine/report/chart.h"

namespace lathelier::receptance {

/// Force over time with the blocks of the hits, shaded by whether they are used, and the windows.
report::Plot tapForcePlot(const TapStudy& study, const Language& language = {});
/// The motion of the sensor likewise.
report::Plot tapMotionPlot(const TapStudy& study, const Language& language = {});
/// Spectrum of the force in dB below its maximum, with the end of the usable range.
report::Plot tapSpectrumPlot(const TapResult& result, const Language& language = {});
/// Phase of the receptance.
report::Plot tapPhasePlot(const TapResult& result);
/// Coherence of all lines; without curves for a single hit.
report::Plot tapCoherencePlot(const TapResult& result, const Language& language = {});

}  // namespace lathelier::receptance
