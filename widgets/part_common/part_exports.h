// The files that are made of a shaft: drawing, CAD, tables. One list for all panels that have one.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/shaft.h"
#include "engine/core/texts.h"
#include "engine/drawing/drawing.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier::part_common {

/// What is written.
struct PartToWrite {
    Shaft shaft;  ///< keeps checkShaft()
    Shaft stock;  ///< for the stock text: what is outside the chuck
    std::function<drawing::Drawing(const Language&)> drawing;
    std::function<void()> requireComplete = {};  ///< before drawings, CAD and stock; throws Error. Empty: it is
    std::function<std::string()> csv = {};       ///< table of rows; empty: cad::shaftCsv()
};

/// The drawing as a PDF of one page, in the size of its sheet.
std::string toPdf(const drawing::Drawing& drawing);

/// In the language of the screen at the time of writing. Their labels are those of now.
std::vector<PanelExport> exportsOf(const std::shared_ptr<const PartToWrite>& part);

}  // namespace lathelier::part_common
