// What the worker of the panel "Pass" computes.
#pragma once

#include <memory>

#include "engine/core/input_file.h"
#include "engine/report/document.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/pass/pass_question.h"

namespace lathelier::pass_panel {

using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct PassPicture {
    PassQuestion question;                              ///< as asked
    std::shared_ptr<const stability::PassResult> pass;  ///< never null
    double speed_rpm = 0;                               ///< that is judged
    std::vector<InputFile> inputs;                      ///< files and items
    Notes notes;                                        ///< of the files and of the result
    bool synthetic = false;                             ///< a source is marked as synthetic
};

/// Reads and computes; safe from any thread. Errors: those of takeShaft(), takeSpindle(), lobesOverPass().
PassPicture passPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

report::Document reportOf(const PassPicture& picture, const Language& language);

}  // namespace lathelier::pass_panel
