// An NC program as an input of a task (task/inputs.h): a file, a program planned in another panel, or either as it was
// changed by hand; and the table of nose radii.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/gcode/program_draft.h"
#include "engine/gcode/program_item.h"
#include "engine/gcode/program_kind.h"
#include "engine/gcode/toolpath.h"
#include "engine/task/inputs.h"

namespace lathelier::gcode {

/// The text of a program. Its facts cost a run of the program: see ProgramFacts.
struct ProgramFile {
    std::string text;  ///< complete text, its bytes
    Notes notes;       ///< none
};

/// A program before it was changed by hand.
struct ProgramText {
    std::string text;
    std::optional<ProgramItem> item;  ///< none: a file
};

struct ProgramInput {
    using File = ProgramFile;
    using Value = ProgramText;
    static constexpr const char* item = programItem;

    static File read(const io::FileToRead& file);
    static Value valueOf(const File& file) { return {file.text, {}}; }
    static io::FileKinds kinds() { return {&programFiles()}; }
    static std::optional<Value> ofItem(const Values& values);
    static std::string contentOf(const Values& values);
};

/// Facts of a program's file, for a window that shows what it understood.
struct ProgramFacts {
    struct File {
        io::FileFacts facts;  ///< see programFiles()
        Notes notes;
    };
    static File read(const io::FileToRead& file);
};

/// A table of tools of LinuxCNC (tool_table.h).
struct ToolTableFile {
    ToolTable tools;
    Notes notes;  ///< none
};

struct ToolTableInput {
    using File = ToolTableFile;
    using Value = ToolTable;
    static constexpr const char* item = "";

    static File read(const io::FileToRead& file);
    static Value valueOf(const File& file) { return file.tools; }
    static io::FileKinds kinds() { return {}; }
};

inline constexpr const char* programRole = "program";
inline constexpr const char* toolsRole = "tools";

/// Inputs of a task by these roles.
task::Input programAsInput();
task::Input toolTableAsInput();

/// A program as it stands: original, or changed by hand.
struct ProgramTaken {
    std::string text;                 ///< bytes to be read
    std::string original;             ///< before the changes
    std::string name;                 ///< path of the file, or name and digest of the item: a draft belongs to one text
    std::string sha256;               ///< of the original
    std::optional<ProgramItem> item;  ///< none: a file
};

/// Looks for the programs that `text` calls in the folder of the parameters (subprograms.h), and enters them there.
/// What is read is listed in the sources, and a note says which lines are those of which file. Without a folder
/// nothing. Errors of findSubprograms().
void takeSubprograms(const std::string& text, ToolpathParameters& parameters, const ToolTable& tools,
                     const Progress& progress, task::Sources& sources);

/// With the note programEdited where a draft stands in place of the original; `drafts` keeps that one only. Errors of
/// the reader with the path; itemNotThere. Precondition: the input is given.
ProgramTaken takeProgram(const project::PanelState& state, std::vector<ProgramDraft>& drafts, Stores& stores,
                         const Progress& progress, task::Sources& sources);

/// Reads the moves; an error of the program is thrown, with its path. `tools`: nose radii by tool.
struct ProgramRun {
    Program program;
    Toolpath path;  ///< free of errors
};
ProgramRun runProgram(std::string text, const std::string& name, const ToolpathParameters& parameters,
                      const ToolTable& tools, const Progress& progress);

/// The first error among the diagnostics; none: the moves are to be trusted.
std::optional<Error> firstError(const Toolpath& toolpath);

}  // namespace lathelier::gcode
