// Polar plots of a report as SVG.
#pragma once

#include <string>

#include "engine/report/chart.h"

namespace lathelier::report {

/// Deviations drawn around the base circle with grid circles and degrees; the magnification, and what a grid division
/// is, are stated beside it with the legend. Long traces are thinned to the smallest and largest value in each quarter
/// degree.
std::string toSvg(const PolarPlot& plot, const Language& language = {});

/// What `plot.magnification` stands for when it is not given: 1, 2 or 5 × 10^n, so that all fits between the core and
/// the rim. 1 for a plot without deviations.
double fittingMagnification(const PolarPlot& plot);

}  // namespace lathelier::report
