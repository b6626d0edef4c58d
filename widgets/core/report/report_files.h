// Reports as files, in the language of the screen.
#pragma once

#include <QString>
#include <optional>

#include "engine/core/progress.h"
#include "engine/report/document.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

/// Writes `document` with the date and what "Verify installation" says now, as HTML or PDF, by the suffix of `path`,
/// and its results beside it as JSON. Each file is written whole or not at all. In any thread: the verification takes
/// seconds. Error fileNotWritable. Throws Cancelled.
void writeReport(const QString& path, report::Document document, const Progress& progress = {});

/// The JSON file beside a report: "shaft.html" → "shaft_result.json".
QString resultFile(const QString& report);

/// Stands in a report for a panel that has no answer and says why: inputs that are missing, an error, or a computation
/// that was stopped.
report::Document partWithoutAnswer(const PanelFacts& facts, const project::PanelState& state,
                                   const std::optional<Error>& error);

/// One document out of the panels' parts: sections and inputs in their order, each part under its title, an input named
/// once.
report::Document joined(const std::vector<report::Document>& parts, const std::string& title);

}  // namespace lathelier
