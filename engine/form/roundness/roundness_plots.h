// The plots of a roundness result and the tables that go with them, for screen and report.
#pragma once

#include "engine/form/roundness/roundness.h"
#include "engine/report/document.h"

namespace lathelier::form {

/// Order, amplitude and phase of the undulations, with their usual causes.
report::Table harmonicsTable(const RoundnessResult& result);

/// The profile, the circles and the contact points of the chosen one.
report::PolarPlot roundnessPolarPlot(const RoundnessResult& result, const Language& language = {});

/// Amplitudes from 2 undulations a turn on, with their usual causes and the cut-offs; all orders, of which only the
/// range of the strong ones is shown initially.
report::Plot spectrumPlot(const RoundnessResult& result, const Language& language = {});

/// RONt by every filter, outlier rule and reference circle.
report::Table methodTable(const RoundnessResult& result, const Language& language = {});

}  // namespace lathelier::form
