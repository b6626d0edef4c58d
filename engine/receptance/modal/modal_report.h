// A measured response and its modes as an answer and a report.
#pragma once

#include "engine/receptance/modal/response_study.h"
#include "engine/report/document.h"

namespace lathelier::receptance {

/// The most flexible mode, the error of the fit, and the modes by flexibility.
report::Answer answer(const ResponseStudy& study, const Language& language = {});

/// One row for each mode of the model.
report::Table modesTable(const ResponseStudy& study);

/// Stiffnesses of all responses that were fitted together, one row each: their signs are the shapes.
report::Table shapesTable(const ResponseStudy& study, const Language& language = {});

/// Answer, modes, charts, method and parameters. `notes`: of the file and of the fit.
report::Document responseReport(const ResponseStudy& study, const Notes& notes, const Language& language = {});

}  // namespace lathelier::receptance
