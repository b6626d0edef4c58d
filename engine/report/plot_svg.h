// Plots and colour maps of a report as SVG.
#pragma once

#include <string>

#include "engine/report/chart.h"

namespace lathelier::report {

/// Curves are decimated: first, lowest, highest and last value in each pixel column.
std::string toSvg(const Plot& plot, const Language& language = {});

/// The cells as one embedded picture, at most 900 × 450 of them (larger grids are averaged), with axes and scale.
std::string toSvg(const ColourMap& map, const Language& language = {});

}  // namespace lathelier::report
