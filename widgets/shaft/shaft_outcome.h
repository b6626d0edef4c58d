// Outcome of the panel Shaft.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/project/project.h"
#include "engine/receptance/shaft_study.h"
#include "engine/report/document.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/shaft/shaft_question.h"

namespace lathelier::shaft_panel {

using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct ShaftOutcome {
    Shaft shaft;                       ///< shaft as computed
    receptance::ShaftHolding holding;  ///< supports as computed
    receptance::ShaftStudy study;      ///< result
    bool table_rules = false;          ///< true: segments of the table, not of the input
    ShaftQuestion question;            ///< question of the request
    std::vector<InputFile> inputs;     ///< files and items
    Notes notes;                       ///< of files and result
    bool synthetic = false;            ///< a source is marked as synthetic
};

/// Reads and computes; thread-safe. Errors: those of readShaftFile(), readSpindle(), studyShaft(); itemNotThere.
ShaftOutcome shaftOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

/// The receptance as an item keeps it: lines without a finite value are left out.
Frf usableResponse(const ShaftOutcome& outcome);

}  // namespace lathelier::shaft_panel
