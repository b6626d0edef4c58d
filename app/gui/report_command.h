// lathelier --report FILE PROJECT: the project's report without a window.
#pragma once

#include <QString>
#include <vector>

#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

/// Computes the panels of the project's report (none named: all that have inputs) and writes them to `file`. A panel
/// without an answer is named in the report with the reason.
/// Returns the exit code of the command line: 0, or 2 to 5 by the kind of the first error, which is said on standard
/// error; 4 when an input is missing.
int runReport(const QString& file, const QString& project, const std::vector<PanelFacts>& panels);

}  // namespace lathelier
