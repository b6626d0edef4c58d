// Plots and colour maps of a report as SVG.
#pragma once

#include <string>

#include "engine/report/chart.h"

namespace lathelier::report {

enum class Sheet { Page, Half };  ///< width of a plot on paper; lettering of both is of one size

/// Curves are decimated: first, lowest, highest and last value in each pixel column. A half sheet has no title: its
/// caption says it.
std::string toSvg(const Plot& plot, const Language& language = {}, Sheet sheet = Sheet::Page);

/// The cells as one embedded picture, at most 900 × 450 of them (larger grids are averaged), with axes and scale.
std::string toSvg(const ColourMap& map, const Language& language = {});

}  // namespace lathelier::report
