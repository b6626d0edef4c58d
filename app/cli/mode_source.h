// Source of the modes for a simulation: given by hand, or fitted to the response of a file or of a computed shaft.
#pragma once

#include "app/cli/verb.h"
#include "engine/core/used_value.h"
#include "engine/stability/modes.h"

namespace lathelier::cli {

/// Result of reading a source.
struct ModeSource {
    std::vector<stability::Mode> modes;  ///< modes of the cutting point
    UsedValues used;                     ///< assumed values
};

/// Takes the options of frfSourceOptions(). Errors: valueNotUnderstood when the request names no source or more than
/// one; modesNeeded where no mode can be fitted; those of readers, of the computation and of the fit. Throws Cancelled.
ModeSource modeSource(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer);

}  // namespace lathelier::cli
