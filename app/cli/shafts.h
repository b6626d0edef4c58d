// Reading what describes a shaft and its machine: SHAFT.json, stock files, materials, spindles.
#pragma once

#include <optional>

#include "app/cli/verb.h"
#include "engine/receptance/shaft_receptance.h"

namespace lathelier::cli {

/// Gives an error of a row of the shaft the path of its file, and the place of the row where the file holds the rows as
/// they were computed (bores divide them). Other errors stay as they are.
void locateSegment(Error& error, const std::string& path, const Shaft& shaft);

/// The options --material and --spindle, and those that say how a shaft is computed.
std::vector<Option> shaftOptions();

/// The shaft in the file at `path` (SHAFT.json, or a stock file), with the material of --material where it is given.
/// Errors carry `path`.
Shaft readShaft(const std::string& path, const Request& request, io::InputFiles& inputs, const Progress& progress,
                Answer& answer);

/// Calls `work`, with locateSegment() for its errors.
template <class Work>
auto namingShaft(const std::string& path, const Shaft& shaft, Work work)
{
    try {
        return work();
    } catch (Error& error) {
        locateSegment(error, path, shaft);
        throw;
    }
}

/// The machine of --spindle; none when it is not given. Errors carry `path`.
std::optional<receptance::SpindleReceptance> readSpindle(const Request& request, io::InputFiles& inputs,
                                                         const Progress& progress, Answer& answer);

/// The text given for a Word option; empty when it was not.
std::string wordOf(const Request& request, const char* key);

}  // namespace lathelier::cli
