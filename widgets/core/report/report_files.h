// Reports as files, in the user's language.
#pragma once

#include <QString>
#include <optional>

#include "engine/core/progress.h"
#include "engine/report/document.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

/// Writes `document` with the date and the present verification, as HTML or PDF by the suffix of `path`, and its
/// results as JSON beside it. Each file is written atomically. Callable from any thread: the verification takes
/// seconds. Error fileNotWritable. Throws Cancelled.
void writeReport(const QString& path, report::Document document, const Progress& progress = {});

/// The JSON file beside a report: "shaft.html" → "shaft_result.json".
QString resultFile(const QString& report);

/// Replaces the part of a panel without an answer and states the reason: missing inputs, an error, or a cancelled
/// computation.
report::Document partWithoutAnswer(const PanelFacts& facts, const project::PanelState& state,
                                   const std::optional<Error>& error);

/// Combines the panels' parts into one document: sections and inputs in order, each part under its title, inputs
/// without duplicates.
report::Document joined(const std::vector<report::Document>& parts, const std::string& title);

}  // namespace lathelier
