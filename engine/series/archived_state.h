// An archived evaluation as it was asked: the state of its panel, and whether its files are still what they were.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/core/progress.h"
#include "engine/project/project.h"

namespace lathelier::series {

enum class FileState : std::uint8_t { Same, Changed, Missing };
Text name(FileState state);

struct ArchivedFile {
    std::string role;
    std::string path;  ///< as it was opened
    std::string sha256;
    FileState state = FileState::Missing;
};

struct ArchivedState {
    project::PanelState state;        ///< inputs with their digests, parameters, reading options
    std::vector<ArchivedFile> files;  ///< all inputs: those of the part, then those of the recipe

    bool isWhole() const;  ///< all files are what they were
};

/// Parameters and fixed inputs are those of the recipe; where the fixed ones lie says the result. What the recipe does
/// not hold (an archive of another program) is left out. Reads the files for their digests. Throws Cancelled.
ArchivedState archivedState(const archive::Record& record, const Progress& progress = {});

}  // namespace lathelier::series
