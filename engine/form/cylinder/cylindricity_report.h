// Cylindricity as a report, and as one sentence.
#pragma once

#include <vector>

#include "engine/form/cylinder/cylinder_surface.h"
#include "engine/report/document.h"

namespace lathelier::form {

/// "CYLt(MZCY) 12.1 µm · within 20 µm ✓": the same on the command line, in the panel and in the report.
report::Answer answer(const CylindricityResult& result);

/// Answer, deviations, verdict and notes: what the command line prints.
report::Section cylindricitySummary(const CylindricityResult& result);

/// Answer, deviations, verdict, notes; the charts of the surface (null: none); method, axes and parameters.
report::Document cylindricityReport(const CylindricityResult& result, const CylinderSurface* surface,
                                    const std::vector<InputFile>& inputs, const Language& language = {});

}  // namespace lathelier::form
