// The modes that a simulation rests on: given by hand, or those of a shaft on its springs.
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

/// Takes the options of frfSourceOptions(). A file of frequency responses gives no modes by itself: this is where a
/// modal fit goes in. Errors: valueNotUnderstood when the request names no source or more than one; modesNeeded.
ModeSource modeSource(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer);

}  // namespace lathelier::cli
