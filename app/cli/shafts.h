// Reading what describes a shaft and its machine: SHAFT.json, stock files, materials, spindles.
#pragma once

#include <optional>

#include "app/cli/verb.h"
#include "engine/receptance/shaft_receptance.h"

namespace lathelier::cli {

/// The options --material and --spindle, and those that say how a shaft is computed.
std::vector<Option> shaftOptions();

/// The shaft in the file at `path` (SHAFT.json, or a stock file), with the material of --material where it is given.
/// Errors carry `path`.
Shaft readShaft(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                Answer& answer);

/// The machine of --spindle; none when it is not given. Errors carry `path`.
std::optional<receptance::SpindleReceptance> readSpindle(const Request& request, io::InputFiles& inputs,
                                                         const Progress& progress, Answer& answer);

/// The text given for a Word option; empty when it was not.
std::string wordOf(const Request& request, const char* key);

}  // namespace lathelier::cli
