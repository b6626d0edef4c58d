// Reports as files, in the language of the screen.
#pragma once

#include <QString>

#include "engine/report/document.h"

namespace lathelier {

/// Writes `document` with the date and what "Verify installation" says now, as HTML or PDF, by the suffix of `path`,
/// and its results beside it as JSON. Each file is written whole or not at all. Error fileNotWritable.
void writeReport(const QString& path, Document document);

/// The JSON file beside a report: "shaft.html" → "shaft_result.json".
QString resultFile(const QString& report);

/// One document out of the panels' parts: sections and inputs in their order, an input named once.
Document joined(const std::vector<Document>& parts, const std::string& title);

}  // namespace lathelier
