// A turning plan for people: what stays, operations, speeds, meridian plots, a sheet for each clamping.
#pragma once

#include "engine/cam/plan.h"
#include "engine/core/json.h"
#include "engine/report/chart.h"
#include "engine/report/document.h"

namespace lathelier::cam {

/// The most that stays, with time and outcome of the check.
report::Answer answer(const TurningPlan& plan, const Language& language = {});

/// Drawing, bar, path and what stays of one clamping; the rest as marks with numbers.
report::Plot meridianPlot(const TurningPlan& plan, std::size_t setup, const Language& language = {});

report::Table operationTable(const SetupPlan& setup);  ///< Operation, Tool, Blocks, Line, Length, Time, Volume, Power
report::Table restTable(const TurningPlan& plan);      ///< From, To, Left, Cause, Tool
report::Table sectionTable(const TurningPlan& plan);   ///< From, To, Diameter, Speed, Cutting speed, f_m, Reason, Rz
report::Table toolTable(const TurningPlan& plan);      ///< set-up sheet: Tool, Use, Name, Nose or corner, Hand

/// Answer and tables, for the terminal.
report::Section planSummary(const TurningPlan& plan, const Language& language = {});

report::Document planReport(const TurningPlan& plan, const Language& language = {});

/// `post`, `setups`, `rest`, `sections`, `check`.
Json toJson(const TurningPlan& plan);

}  // namespace lathelier::cam
