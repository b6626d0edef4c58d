// A report as PDF, from the same document as the HTML; plots are vector graphics.
#pragma once

#include <string>

#include "engine/report/document.h"

namespace lathelier {

/// The bytes of an A4 PDF. Needs a QGuiApplication (fonts), but no display.
std::string toPdf(const report::Document& document, const Language& language = {});

}  // namespace lathelier
