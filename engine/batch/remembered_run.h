// batch.json: what a folder of results was asked for, so that a run can be continued by the name of the folder alone.
#pragma once

#include <string>
#include <vector>

namespace lathelier::batch {

struct RememberedRun {
    std::string recipe;               ///< path as it was given
    std::vector<std::string> inputs;  ///< files, folders, lists, likewise
};

/// Writes batch.json into the folder, which is made. Error fileNotWritable.
void remember(const std::string& folder, const RememberedRun& run);

/// Paths are as they were given where the working folder is the same, else with the one of that run. Errors:
/// batchNotRemembered; malformed, keyMissing (path, line, column).
RememberedRun remembered(const std::string& folder);

}  // namespace lathelier::batch
