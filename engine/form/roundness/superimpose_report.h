// Superposition of two profiles as a part of a report.
#pragma once

#include "engine/form/roundness/superimpose.h"
#include "engine/report/document.h"

namespace lathelier::form {

/// Quantities of the superposition, both profiles as deviations from the first's circle, and their difference.
report::Section superimposeSection(const SuperimposeResult& result);

/// Both profiles and their difference about a circle of this radius.
report::PolarPlot superimposedPolarPlot(const SuperimposeResult& result, double base_radius_mm);

}  // namespace lathelier::form
