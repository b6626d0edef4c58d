// Outcome of the panel Drawing: the checked shaft and its properties.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/core/input_file.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/project/project.h"
#include "engine/report/document.h"
#include "engine/shaft/shaft_item.h"
#include "engine/task/stores.h"
#include "widgets/drawing/drawing_question.h"

namespace lathelier::drawing_panel {

struct DrawingOutcome {
    DrawingQuestion question;                ///< question of the request
    Shaft shaft;                             ///< shaft that satisfies checkShaft()
    std::optional<double> mass_kg;           ///< mass; none: the material is unknown
    Notes remarks;                           ///< notes of checkShaft() and of the limits of CAD files
    Notes notes;                             ///< remarks and notes of the file
    std::vector<InputFile> inputs;           ///< the file or item read
    bool synthetic = false;                  ///< true: the source is marked as synthetic
    std::optional<RecoveredFrom> recovered;  ///< scan from which an item was recognised
};

/// Reads and checks; thread-safe. Errors: those of PartStore, checkShaft(); itemNotThere.
DrawingOutcome drawingOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The sheet with texts and numbers in this language.
drawing::Drawing drawingOf(const DrawingOutcome& outcome, const Language& language);

report::Answer answerOf(const DrawingOutcome& outcome);
report::Table rowsTable(const DrawingOutcome& outcome, const Language& language);
/// Of rows with measured values beside set ones: each size, measured and nominal, difference and U. Empty without.
report::Table measuredTable(const DrawingOutcome& outcome, const Language& language);
/// The remarks, or one line stating that there are none.
report::Table remarksTable(const DrawingOutcome& outcome, const Language& language);
report::Document reportOf(const DrawingOutcome& outcome, const Language& language);

}  // namespace lathelier::drawing_panel
