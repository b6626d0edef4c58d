// A shaft study as an answer and as a report.
#pragma once

#include "engine/receptance/shaft/shaft_study.h"
#include "engine/report/document.h"

namespace lathelier::receptance {

/// First natural frequency, mass and static compliance.
report::Answer answer(const ShaftStudy& study, const Language& language = {});

/// Natural frequencies, undamped.
report::Table frequenciesTable(const std::vector<double>& frequencies_hz);

/// Drawing, frequencies, shapes, response, segments, method and parameters.
report::Document shaftReport(const ShaftStudy& study, const Shaft& shaft, const ShaftHolding& holding,
                             const Language& language = {});

}  // namespace lathelier::receptance
