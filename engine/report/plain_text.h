// The short form of a report for a terminal.
#pragma once

#include <string>

#include "engine/report/document.h"

namespace lathelier::report {

/// Headlines, paragraphs and tables of one section as aligned UTF-8 text; plots, maps, pictures and notes are left out.
std::string toPlainText(const Section& section, const Language& language = {});

}  // namespace lathelier::report
