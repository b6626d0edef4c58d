// What the worker of the panel "Speed" computes.
#pragma once

#include <memory>
#include <optional>

#include "engine/core/input_file.h"
#include "engine/core/used_value.h"
#include "engine/report/document.h"
#include "engine/stability/lobes.h"
#include "engine/stability/speed_choice.h"
#include "widgets/chatter_common/taken_input.h"
#include "widgets/speed/speed_question.h"

namespace lathelier::speed_panel {

using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct SpeedPicture {
    SpeedQuestion question;                              ///< as asked
    std::shared_ptr<const Frf> frf;                      ///< at the free end; null while a value is missing
    std::shared_ptr<const stability::LobeResult> lobes;  ///< about the selected speed; null likewise
    std::optional<stability::SpeedResult> speed;         ///< none: see `problem`
    std::optional<Error> problem;                        ///< a value that is missing, or no stable speed
    std::vector<InputFile> inputs;                       ///< files and items
    UsedValues used;                                     ///< the material, and who stated it
    Notes notes;                                         ///< of the files and of the results
    bool synthetic = false;                              ///< a source is marked as synthetic
};

/// Reads and computes; safe from any thread. Errors: those of takeShaft(), takeSpindle(), shaftReceptance().
SpeedPicture speedPicture(const project::PanelState& state, Stores& stores, const Progress& progress);

/// Precondition: there is a speed.
report::Document reportOf(const SpeedPicture& picture, const Language& language);

}  // namespace lathelier::speed_panel
