// Report of a turning plan: residual material, operations, speeds, meridian plots, a set-up sheet for each clamping.
#pragma once

#include "engine/cam/plan.h"
#include "engine/core/json.h"
#include "engine/report/chart.h"
#include "engine/report/document.h"

namespace lathelier::cam {

/// Largest residual material, machining time, result of the check.
report::Answer answer(const TurningPlan& plan, const Language& language = {});

/// Drawing, bar, tool path and remaining stock of one clamping; residual material as numbered marks.
report::Plot meridianPlot(const TurningPlan& plan, std::size_t setup, const Language& language = {});

report::Table operationTable(const SetupPlan& setup);  ///< Operation, Tool, Blocks, Line, Length, Time, Volume, Power
report::Table restTable(const TurningPlan& plan);      ///< From, To, Left, Cause, Tool
report::Table notMadeTable(const TurningPlan& plan);
report::Table sectionTable(const TurningPlan& plan);  ///< From, To, Diameter, Speed, Cutting speed, f_m, Reason, Rz
report::Table toolTable(const TurningPlan& plan);     ///< set-up sheet: Tool, Use, Name, Nose or corner, Hand

/// Answer and tables, for the terminal.
report::Section planSummary(const TurningPlan& plan, const Language& language = {});

report::Document planReport(const TurningPlan& plan, const Language& language = {});

/// `post`, `setups`, `rest`, `sections`, `check`.
Json toJson(const TurningPlan& plan);

}  // namespace lathelier::cam
