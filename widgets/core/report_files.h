// Reports as files, in the language of the screen.
#pragma once

#include <QString>

#include "engine/report/document.h"

namespace lathelier {

/// Writes `document` as HTML or PDF, by the suffix of `path`; whole or not at all. Error FileNotWritable.
void writeReport(const QString& path, const Document& document);

/// One document out of the panels' parts: sections and inputs in their order, an input named once.
Document joined(const std::vector<Document>& parts, const std::string& title);

}  // namespace lathelier
