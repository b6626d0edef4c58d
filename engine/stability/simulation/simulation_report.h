// A simulated cut as charts, answer and report.
#pragma once

#include "engine/core/json.h"
#include "engine/core/quantities.h"
#include "engine/report/document.h"
#include "engine/stability/simulation/simulation.h"

namespace lathelier::stability {

/// "stable", "chatter", "undecided".
const char* key(CutVerdict cut);

const std::vector<QuantityOf<SimulationResult>>& quantitiesOf(const SimulationResult*);

/// Deflection over the time; of a long waveform the least and the largest value of each stretch.
report::Plot waveformPlot(const SimulationResult& result);

report::Answer answer(const SimulationResult& result, const Language& language = {});
report::Section simulationSummary(const SimulationResult& result, const Language& language = {});
report::Document simulationReport(const SimulationResult& result, const Language& language = {});

}  // namespace lathelier::stability
