// The parts of a run, from files, folders and lists:
//   - a file is a part;
//   - a folder gives its regular files that are not hidden, in byte order of their names, without those of its folders;
//     of a record in two files (NAME.dat, NAME.par) one;
//   - a list is a text whose first line that is not empty names a file that exists, beside the list or in the working
//     folder, or is {"inputs": {role: path or [paths]}}. The other lines are alike; one that names a missing file is
//     such a part, which fails by itself.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/batch/recipe.h"

namespace lathelier::batch {

struct Part {
    std::vector<std::pair<std::string, std::string>> files;  ///< key in PanelState::inputs and path; at least one

    const std::string& name() const { return files.front().second; }
};

/// Errors: fileNotReadable for a folder; batchNeedsGroups where parts have several roles and no group states them;
/// malformed, recipeMemberUnknown (path and line) for a line of a list. Throws Cancelled.
std::vector<Part> partsOf(const std::vector<std::string>& inputs, const Recipe& recipe, const Progress& progress = {});

}  // namespace lathelier::batch
