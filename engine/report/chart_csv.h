// The numbers of a chart as comma-separated text: decimal point in every language, full precision.
#pragma once

#include <string>

#include "engine/report/chart.h"

namespace lathelier::report {

/// Curves in columns; curves of equal x share the x column. A plot whose curves are paths (`along`) has a line for each
/// sample instead: curve, along, x, y.
std::string toCsv(const Plot& plot, const Language& language = {});

/// One line for each cell with data: x, y, value.
std::string toCsv(const ColourMap& map, const Language& language = {});

}  // namespace lathelier::report
