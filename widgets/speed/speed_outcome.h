// Outcome of the panel Speed.
#pragma once

#include <memory>
#include <optional>

#include "engine/core/input_file.h"
#include "engine/core/used_value.h"
#include "engine/report/document.h"
#include "engine/stability/lobes.h"
#include "engine/stability/speed_choice.h"
#include "widgets/chatter_common/input_value.h"
#include "widgets/speed/speed_question.h"

namespace lathelier::speed_panel {

using chatter_common::shaftRole;
using chatter_common::spindleRole;

struct SpeedOutcome {
    SpeedQuestion question;                              ///< question of the request
    std::shared_ptr<const Frf> frf;                      ///< at the free end; null while a value is missing
    std::shared_ptr<const stability::LobeResult> lobes;  ///< about the selected speed; null while a value is missing
    std::optional<stability::SpeedResult> speed;         ///< none: see `problem`
    std::optional<Error> problem;                        ///< a value that is missing, or no stable speed
    std::vector<InputFile> inputs;                       ///< files and items
    UsedValues used;                                     ///< the material with its origin
    Notes notes;                                         ///< of the files and of the results
    bool synthetic = false;                              ///< a source is marked as synthetic
};

/// Reads and computes; thread-safe. Errors: those of takeShaft(), takeSpindle(), shaftReceptance().
SpeedOutcome speedOutcome(const project::PanelState& state, Stores& stores, const Progress& progress);

/// Precondition: there is a speed.
report::Document reportOf(const SpeedOutcome& outcome, const Language& language);

}  // namespace lathelier::speed_panel
