// The project as a value: which files, which parameters, which results are in the report. Panels by id.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/value.h"

namespace lathelier {

/// An input file of a panel, with the decisions made at import.
struct Source {
    std::string path;    ///< absolute in memory, relative to the project file on disk
    Values import;       ///< ImportOptions as values
    std::string sha256;  ///< of the content last read; empty: not read yet
    bool synthetic = false;
    friend bool operator==(const Source&, const Source&) = default;
};

/// What a panel works on. Its parameters are those of its fields<P>().
struct PanelState {
    std::map<std::string, Source> inputs;  ///< by role: "reference", "copy"
    Values parameters;
    friend bool operator==(const PanelState&, const PanelState&) = default;
};

struct Project {
    std::string title;
    std::string workspace = "inspection";
    std::map<std::string, PanelState> panels;  ///< by panel id: "compare"
    std::vector<std::string> report;           ///< ids of the panels in the report, in order
    friend bool operator==(const Project&, const Project&) = default;
};

/// Reads a project file (JSON, format version 1; see project_json.h). Older versions are migrated, newer ones refused.
/// Source paths come out absolute; the sources themselves are not looked at. Errors: those of FileBytes, fileEmpty,
/// malformed (line, column; also more than 1000 panels, 1000 inputs of a panel or 10 000 ranges of a parameter),
/// versionTooNew.
struct ProjectFile {
    Project project;
    std::string sha256;  ///< of the project file
};
ProjectFile readProject(const std::string& path);

/// What became of the sources since the project was saved: sourceChanged where the content no longer has the stored
/// SHA-256, sourceMissing where there is no file. Files too large to be read are left out. Reads all of them: not for
/// the GUI thread. Throws Cancelled.
Notes checkSources(const Project& project, const Progress& progress = {});

/// Writes beside and renames: the old file stays whole if anything fails. Gives the SHA-256 of what was written. Error
/// fileNotWritable.
std::string writeProject(const std::string& path, const Project& project);

}  // namespace lathelier
