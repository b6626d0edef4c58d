// A recognition as a report and as tables.
#pragma once

#include <vector>

#include "engine/features/nominal/accepted_sizes.h"
#include "engine/features/report/recognition_answer.h"
#include "engine/report/document.h"

namespace lathelier::features {

/// The rows, then those of bores as "B1.2", with the uncertainty beside each value (k = 2) and the suggested nominal
/// sizes.
report::Table rowsTable(const Recognition& result, const Language& language = {});
inline constexpr int nominalColumn = 3;  ///< of rowsTable(), from 0

/// "⌀ 30 (+0.4 µm, chance 10 %, h6)": the text of one suggestion.
std::string suggestionText(const Suggestion& suggestion, const Language& language = {});

/// The paper's Table 1: cylinders with their chamfers folded in.
report::Table stepsTable(const std::vector<ShaftStep>& steps);

/// Answer, rows, features, marks, gaps and notes: what the command line prints with report::toPlainText().
report::Section recognitionSummary(const Recognition& result, const Language& language = {});

/// The same with charts, ends, `steps` as the published table, how well it fits, method and parameters.
report::Document recognitionReport(const Recognition& result, const std::vector<ShaftStep>& steps,
                                   const std::vector<InputFile>& inputs, const Language& language = {});

/// The rows as CSV: decimal point, full precision, uncertainties in columns of their own.
std::string rowsCsv(const Recognition& result);

}  // namespace lathelier::features
