// A frequency response as charts, for screen and paper.
#pragma once

#include <optional>

#include "engine/core/frf.h"
#include "engine/report/chart.h"

namespace lathelier::receptance {

/// The linear axis of all plots over the frequency.
report::Axis frequencyAxis();

/// Magnitude of the receptance over the frequency, both logarithmic.
report::Plot magnitudePlot(const Frf& frf);

/// Real and imaginary part, with the frequency of the least real part as a line.
report::Plot realImaginaryPlot(const Frf& frf, std::optional<double> least_hz = {}, const Language& language = {});

}  // namespace lathelier::receptance
