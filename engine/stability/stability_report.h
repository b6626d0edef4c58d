// Lobes and the recommended speed as a report, and as an answer.
#pragma once

#include <vector>

#include "engine/report/document.h"
#include "engine/stability/stability_plots.h"

namespace lathelier::stability {

report::Answer answer(const LobeResult& result, const Language& language = {});
report::Answer answer(const SpeedResult& result, const Language& language = {});

/// One row for each lobe.
report::Table candidatesTable(const SpeedResult& result);

/// Summary for the command line.
report::Section lobesSummary(const LobeResult& result, const Language& language = {});
report::Section speedSummary(const SpeedResult& result, const Language& language = {});

/// Lobes, the underlying frequency response, the chosen speed and the operating point where there are any, method and
/// parameters. `used`: values assumed for the frequency response.
report::Document lobesReport(const LobeResult& result, const Frf& frf, const SpeedResult* speed, const UsedValues& used,
                             const Language& language = {}, const std::optional<OperatingPoint>& point = {});
/// `near`: lobes about the selected and the recommended speed.
report::Document speedReport(const SpeedResult& result, const LobeResult& near, const Frf& frf, const UsedValues& used,
                             const Language& language = {});

}  // namespace lathelier::stability
