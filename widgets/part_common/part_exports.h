// The files that the panel "Drawing" writes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "widgets/core/panel/panel_facts.h"
#include "widgets/drawing/drawing_picture.h"

namespace lathelier::drawing_panel {

/// The drawing as a PDF of one page, in the size of its sheet.
std::string toPdf(const drawing::Drawing& drawing);

/// In the language of the screen at the time of writing. Their labels are those of now.
std::vector<PanelExport> exportsOf(const std::shared_ptr<const DrawingPicture>& picture);

}  // namespace lathelier::drawing_panel
