// What the worker of the panel "Drawing" computes: the shaft that is drawn, checked, and what it says of itself.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/core/input_file.h"
#include "engine/core/shaft_item.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/project/project.h"
#include "engine/report/document.h"
#include "widgets/core/files/stores.h"
#include "widgets/drawing/drawing_question.h"

namespace lathelier::drawing_panel {

using part_common::identity;
using part_common::shaftRole;

struct DrawingPicture {
    DrawingQuestion question;                ///< as asked
    Shaft shaft;                             ///< keeps checkShaft()
    std::optional<double> mass_kg;           ///< none: no material is known
    Notes remarks;                           ///< of checkShaft() and of what CAD files leave out
    Notes notes;                             ///< the same with those of the file
    std::vector<InputFile> inputs;           ///< the file or item
    bool synthetic = false;                  ///< the source is marked as synthetic
    std::optional<RecoveredFrom> recovered;  ///< the scan that an item was recognised in
};

/// Reads and checks; safe from any thread. Errors: those of PartStore, checkShaft(); itemNotThere.
DrawingPicture drawingPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The sheet with its words and numbers in this language.
drawing::Drawing drawingOf(const DrawingPicture& picture, const Language& language);

report::Answer answerOf(const DrawingPicture& picture);
report::Table rowsTable(const DrawingPicture& picture, const Language& language);
/// Of rows with measured values beside set ones: each size, measured and nominal, difference and U. Empty without.
report::Table measuredTable(const DrawingPicture& picture, const Language& language);
/// The remarks; one line that says so where there are none.
report::Table remarksTable(const DrawingPicture& picture, const Language& language);
report::Document reportOf(const DrawingPicture& picture, const Language& language);

}  // namespace lathelier::drawing_panel
