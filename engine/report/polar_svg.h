// Polar plots of a report as SVG.
#pragma once

#include <string>

#include "engine/report/chart.h"

namespace lathelier::report {

/// Deviations drawn around the base circle with grid circles and degrees; the magnification, and the grid division are
/// stated beside it with the legend. Long traces are decimated to the smallest and largest value in each quarter
/// degree.
std::string toSvg(const PolarPlot& plot, const Language& language = {});

/// Default of `plot.magnification`: 1, 2 or 5 × 10^n, such that everything fits between inner and outer radius. 1 for a
/// plot without deviations.
double fittingMagnification(const PolarPlot& plot);

}  // namespace lathelier::report
