// lathelier --report FILE PROJECT: the project's report without a window.
#pragma once

#include <QString>
#include <vector>

#include "widgets/core/panel_facts.h"

namespace lathelier {

/// Computes the panels of the project's report (none named: all that have inputs) and writes them to `file`.
/// Returns the exit code of COMMAND_LINE: 0, or 2, 3, 4 by the kind of the error, which is said on standard error.
int runReport(const QString& file, const QString& project, const std::vector<PanelFacts>& panels);

}  // namespace lathelier
