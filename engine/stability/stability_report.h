// Lobes and the recommended speed as a report, and as an answer.
#pragma once

#include <vector>

#include "engine/report/document.h"
#include "engine/stability/stability_plots.h"

namespace lathelier::stability {

report::Answer answer(const LobeResult& result, const Language& language = {});
report::Answer answer(const SpeedResult& result, const Language& language = {});

/// One row for each lobe, by the rule of the papers.
report::Table candidatesTable(const SpeedResult& result);

/// One row for each pocket of the range, the deepest first: speed, limit, margin to the depth asked for.
report::Table pocketsTable(const SafeSpeed& safe, bool is_relative);

/// Summary for the command line.
report::Section lobesSummary(const LobeResult& result, const Language& language = {});
report::Section speedSummary(const SpeedResult& result, const Language& language = {});

/// Lobes, the underlying frequency response, the speeds and the operating point where they are marked, method and
/// parameters. `used`: values assumed for the frequency response.
report::Document lobesReport(const LobeResult& result, const Frf& frf, const LobesMarks& marks, const UsedValues& used,
                             const Language& language = {});
/// `near`: lobes about the selected and the recommended speed.
report::Document speedReport(const SpeedResult& result, const LobeResult& near, const Frf& frf, const LobesMarks& marks,
                             const UsedValues& used, const Language& language = {});

}  // namespace lathelier::stability
