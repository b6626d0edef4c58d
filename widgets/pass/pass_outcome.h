// Outcome of the panel Pass.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/report/document.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/pass/pass_question.h"

namespace lathelier::pass_panel {

using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct PassOutcome {
    PassQuestion question;                              ///< question of the request
    std::shared_ptr<const stability::PassResult> pass;  ///< never null
    double speed_rpm = 0;                               ///< evaluated speed
    std::vector<InputFile> inputs;                      ///< files and items
    Notes notes;                                        ///< of the files and of the result
    bool synthetic = false;                             ///< a source is marked as synthetic
};

/// Reads and computes; thread-safe. Errors: those of takeShaft(), takeSpindle(), lobesOverPass().
PassOutcome passOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

report::Document reportOf(const PassOutcome& outcome, const Language& language);

}  // namespace lathelier::pass_panel
