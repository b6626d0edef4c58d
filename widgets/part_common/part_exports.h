// Exports of a shaft (drawing, CAD, tables), common to all panels.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/texts.h"
#include "engine/drawing/drawing.h"
#include "engine/shaft/shaft.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier::part_common {

/// The part to be exported.
struct PartToWrite {
    Shaft shaft;  ///< shaft that satisfies checkShaft()
    Shaft stock;  ///< shaft for the stock text: the part outside the chuck
    std::function<drawing::Drawing(const Language&)> drawing;
    std::function<void()> require_complete = {};  ///< checked before drawings, CAD and stock are written; throws Error.
                                                  ///< Empty: always complete
    std::function<std::string()> csv = {};        ///< table of rows as CSV; empty: cad::shaftCsv()
};

/// The drawing as a PDF of one page, in the size of its sheet.
std::string toPdf(const drawing::Drawing& drawing);

/// Written in the user's language at the time of writing; labels in the present language.
std::vector<PanelExport> exportsOf(const std::shared_ptr<const PartToWrite>& part);

}  // namespace lathelier::part_common
