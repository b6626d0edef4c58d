// Modes of a response as a simulation takes them.
#pragma once

#include <string>
#include <vector>

#include "engine/core/frf.h"
#include "engine/stability/modes.h"
#include "engine/task/stores.h"

namespace lathelier::stability {

/// Fitted to the response, once for each `basis`. `found` receives the notes of the fit and modesFitted. Error
/// modesNeeded where no mode can be fitted; those of fitModes(). Throws Cancelled.
std::vector<Mode> fittedModes(const Frf& frf, const std::string& basis, Stores& stores, Notes& found,
                              const Progress& progress);

}  // namespace lathelier::stability
