// A report as one self-contained HTML file: no scripts, no links, pictures inside, ready to print.
#pragma once

#include <string>

#include "engine/report/document.h"

namespace lathelier::report {

/// Deterministic: the same document gives the same bytes.
std::string toHtml(const Document& document, const Language& language = {});

}  // namespace lathelier::report
