// What the worker of the panel "Shaft" computes.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/project/project.h"
#include "engine/receptance/shaft_study.h"
#include "engine/report/document.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/shaft/shaft_question.h"

namespace lathelier::shaft_panel {

using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct ShaftPicture {
    Shaft shaft;                       ///< as computed
    receptance::ShaftHolding holding;  ///< likewise
    receptance::ShaftStudy study;      ///< the answer
    bool table_rules = false;          ///< the segments are those of the table, not of the input
    ShaftQuestion question;            ///< as asked
    std::vector<InputFile> inputs;     ///< files and items
    Notes notes;                       ///< of files and result
    bool synthetic = false;            ///< a source is marked as synthetic
};

/// Reads and computes; safe from any thread. Errors: those of readShaftFile(), readSpindle(), studyShaft();
/// itemNotThere.
ShaftPicture shaftPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The receptance as an item keeps it: lines without a finite value are left out.
Frf usableResponse(const ShaftPicture& picture);

}  // namespace lathelier::shaft_panel
