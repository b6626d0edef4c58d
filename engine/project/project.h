// The project as a value: which parts, files and parameters, which results are in the report. Panels by id.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/value.h"

namespace lathelier::project {

/// An input file of a panel, with the decisions made at import.
struct Source {
    std::string path;        ///< absolute in memory, relative to the project file on disk; empty: an item
    Values import;           ///< ImportOptions as values by key
    std::string sha256;      ///< of the content last read; empty: not read yet
    bool synthetic = false;  ///< marked as made by a program, not measured
    std::string item = {};   ///< name of an item of the project, in place of a file; empty: a file
    friend bool operator==(const Source&, const Source&) = default;
};

/// Origin of an item: the panel that made it, and its inputs.
struct Origin {
    std::string panel;                ///< panel id; empty: not made by a panel (typed, from a library)
    std::string version;              ///< version of the program
    std::string state_sha256;         ///< of the panel's state at that time: stateDigest()
    std::vector<std::string> inputs;  ///< SHA-256 of its input files
    friend bool operator==(const Origin&, const Origin&) = default;
};

/// A shaft, an FRF, a machine, a material… made in one panel and used in others, by its description (toValues()).
struct Item {
    std::string kind;  ///< item kind, such as "shaft"
    Values values;     ///< its description by key, as toValues() gives it
    Origin origin;
    friend bool operator==(const Item&, const Item&) = default;
};

/// State of a panel: inputs and parameters by its fields<P>().
struct PanelState {
    std::map<std::string, Source> inputs;    ///< by role: "reference", "copy"
    Values parameters;                       ///< by key, as in fields<P>()
    std::map<std::string, Item> items = {};  ///< of inputs that are items, by role: filled by resolved(), not saved
    friend bool operator==(const PanelState&, const PanelState&) = default;
};

/// What the project knows of one part: its files, the questions asked about it, what was made of it.
struct Part {
    std::string name;                          ///< of the part; may be empty
    std::map<std::string, PanelState> panels;  ///< by panel id: "compare"
    std::vector<std::string> report;           ///< ids of the panels in the report, in order
    std::map<std::string, Item> items;         ///< items by name
    Values title_block;                        ///< of its reports, by key (report::TitleBlock)
    std::map<std::string, Values> views;       ///< by panel id: view settings; without effect on results
    friend bool operator==(const Part&, const Part&) = default;
};

/// One part is shown: the project itself. The others wait in a list (parts.h).
struct Project : Part {
    std::string title;               ///< title of the project; may be empty
    std::string workspace = "scan";  ///< id of the question that is shown
    bool recipe = false;             ///< opened, it begins a new project (recipe.h)
    Values shop;                     ///< choice of machine, tools, material by key; empty: that of the settings
    std::vector<Part> others;        ///< the parts that are not shown, in order
    std::size_t place = 0;           ///< of the shown part in the list of all: at most others.size()
    friend bool operator==(const Project&, const Project&) = default;
};

/// The state of panel `id` with the items that its inputs name; empty when the project has none. The input of a missing
/// item has no value.
PanelState resolved(const Project& project, const std::string& id);

/// Digest of the state: SHA-256 over inputs (their content where it is known) and parameters.
std::string stateDigest(const PanelState& state);

/// Origin of an item made by panel `id` now.
Origin originOf(const Project& project, const std::string& id, const std::string& version);

/// Whether the state of the panel that made the item has changed since. False for an item not made by a panel.
bool isOutdated(const Project& project, const Item& item);

/// Reads a project file (JSON, see project_json.h). Older format versions are migrated, newer ones refused. Source
/// paths come out absolute; the sources themselves are not opened. Errors: those of FileBytes, fileEmpty, malformed
/// (line, column; also more than 1000 parts, panels or items, 1000 inputs of a panel or a list of more than 10 000),
/// versionTooNew.
struct ProjectFile {
    Project project;     ///< as read, migrated to this version
    std::string sha256;  ///< of the project file
};
ProjectFile readProject(const std::string& path);

/// Changes of the sources of all parts since the project was saved: sourceChanged where the content no longer has the
/// stored SHA-256, sourceMissing where there is no file. Files too large to be read are left out. Reads all of them:
/// not for the GUI thread. Throws Cancelled.
Notes checkSources(const Project& project, const Progress& progress = {});

/// Writes a temporary file and renames it: on failure the old file is unchanged. Returns the SHA-256 of the file. Error
/// fileNotWritable.
std::string writeProject(const std::string& path, const Project& project);

}  // namespace lathelier::project
