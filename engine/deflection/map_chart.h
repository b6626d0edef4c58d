// The map over depth and feed as a chart: colours, lines of equal error, the tolerance, the time in cut, and the
// operating point of the program.
#pragma once

#include "engine/deflection/what_if.h"
#include "engine/report/chart.h"

namespace lathelier::deflection {

/// Points of lines along which a map has one value; NaN separates pieces.
struct Isoline {
    std::vector<double> depth_mm, feed_mm_rev;
};

/// By linear interpolation along the sides of the cells (marching squares). Cells with a NaN corner are skipped.
Isoline isolineOf(const DeflectionMap& map, double error_um);

/// With a tolerance: red beyond, blue within.
report::Plot mapChart(const DeflectionMap& map, const Language& language = {});

}  // namespace lathelier::deflection
