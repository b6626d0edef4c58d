// Charts of the receptance of a chuck face and of the quality of its identification.
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/eirc/spindle_check.h"
#include "engine/report/document.h"

namespace lathelier::receptance {

/// H, L × 100 mm and P × (100 mm)² over frequency, in mm/N: magnitude, and phase in degrees. Springs are drawn from
/// 10 to 5000 Hz.
report::Plot spindleMagnitudePlot(const SpindleReceptance& spindle);
report::Plot spindlePhasePlot(const SpindleReceptance& spindle);

/// Condition number of the identification by line.
report::Plot conditionPlot(const SpindleIdentification& found);

/// Residual by line in percent: of every response faintly, of the worst one and of all that are used.
report::Plot residualPlot(const SpindleCheck& check, const Language& language = {});

/// Magnitude of the responses of the rod that was held out, measured and predicted. No curves without a held-out rod.
report::Plot heldOutPlot(const SpindleCheck& check, const Language& language = {});

/// One row for each response: rod, nodes, residual, χ².
report::Table responsesTable(const SpindleCheck& check);

}  // namespace lathelier::receptance
