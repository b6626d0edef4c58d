// Report of the check of a program: answer, tables, meridian plot, document, JSON.
#pragma once

#include "engine/cam/check/turning_check.h"
#include "engine/core/json.h"
#include "engine/report/chart.h"
#include "engine/report/document.h"

namespace lathelier::cam {

/// The largest residual material with the verdict, and the three largest findings.
report::Answer answer(const CheckResult& result, const Language& language = {});

/// Nominal contour of the part, remaining stock, chuck, tailstock and findings. z from the raw end of the stock.
report::Plot meridianPlot(const CheckResult& result, const Shaft& part, const Language& language = {});

report::Table findingTable(const CheckResult& result);  ///< Line, Finding, z, Radius, Depth
report::Table restTable(const CheckResult& result);     ///< From, To, Left, Cause, Tool

/// Answer and tables, for the terminal.
report::Section checkSummary(const CheckResult& result, const Language& language = {});

/// `part`: as drawn, in its first clamping.
report::Document checkReport(const CheckResult& result, const Shaft& part, const Language& language = {});

/// `check`, `rest`, `dialect`, `words`, `words_understood`, `diagnostics`; the first two null where the program has
/// errors.
Json toJson(const CheckResult& result);

}  // namespace lathelier::cam
