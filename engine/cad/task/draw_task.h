// The task draw: a shaft checked, and written as drawing, CAD and tables. The verb and the panel Drawing.
//
// Precedence: tables of segments and bores that were changed by hand rule over the file they were changed from.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/cad/task/draw_question.h"
#include "engine/cad/task/taken_part.h"
#include "engine/drawing/shaft_drawing.h"
#include "engine/task/task.h"

namespace lathelier::cad {

struct DrawOutcome : task::Answered {
    DrawQuestion question;                         ///< the parameters as a value
    Shaft shaft;                                   ///< shaft that satisfies checkShaft()
    std::optional<double> mass_kg;                 ///< mass; none: the material is unknown
    Notes remarks;                                 ///< notes of checkShaft() and of the limits of CAD files
    std::shared_ptr<const Loaded<PartFile>> file;  ///< null: an item, or a table
};

/// `has_cad`: what CAD files leave out is remarked. Errors: those of PartInput, checkShaft(), with the path. Throws
/// Cancelled.
DrawOutcome answerDraw(const project::PanelState& state, bool has_cad, Stores& stores, task::Sources& sources,
                       const Progress& progress);

/// The sheet with texts and numbers in this language.
drawing::Drawing drawingOf(const DrawOutcome& outcome, const Language& language);

report::Answer answer(const DrawOutcome& outcome);
report::Table rowsTable(const DrawOutcome& outcome, const Language& language);
/// Of rows with measured values beside set ones: each size, measured and nominal, difference and U. Empty without.
report::Table measuredTable(const DrawOutcome& outcome, const Language& language);
/// The remarks, or one line stating that there are none.
report::Table remarksTable(const DrawOutcome& outcome, const Language& language);
report::Document reportOf(const DrawOutcome& outcome, const Language& language);

task::Outcome outcomeOf(const std::shared_ptr<const DrawOutcome>& outcome);

const task::Task& drawTask();

}  // namespace lathelier::cad
