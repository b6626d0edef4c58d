// A drawing as a document.
#pragma once

#include <string>

#include "engine/drawing/drawing.h"

namespace lathelier::part_common {

/// The drawing as a PDF of one page, in the size of its sheet.
std::string toPdf(const drawing::Drawing& drawing);

}  // namespace lathelier::part_common
