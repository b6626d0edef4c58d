// The modes that a simulation rests on: given by hand, or fitted to the response of a file or of a computed shaft.
#pragma once

#include "app/cli/verb.h"
#include "engine/core/used_value.h"
#include "engine/stability/modes.h"

namespace lathelier::cli {

/// What a verb found of its source.
struct ModeSource {
    std::vector<stability::Mode> modes;  ///< of the point that is cut
    UsedValues used;                     ///< what was assumed on the way
};

/// Takes the options of frfSourceOptions(). Errors: valueNotUnderstood when the request names no source or more than
/// one; modesNeeded where no mode can be fitted; those of readers, of the computation and of the fit. Throws Cancelled.
ModeSource modeSource(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer);

}  // namespace lathelier::cli
