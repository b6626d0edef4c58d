// Caches of NC programs and set-ups, and their use in a computation.
#pragma once

#include <optional>
#include <string>

#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/setup_file.h"
#include "engine/gcode/program_item.h"
#include "engine/gcode/program_kind.h"
#include "widgets/core/files/file_cache.h"
#include "widgets/core/files/stores.h"
#include "widgets/deflection_common/program_draft.h"

namespace lathelier::deflection_common {

inline constexpr const char* programRole = "program";
inline constexpr const char* setupRole = "setup";  ///< role of the set-up; also used: shaftRole for the stock,
                                                   ///< spindleRole for the chuck

/// The text of a program with its facts.
struct ProgramFile {
    std::string text;     ///< complete text
    io::FileFacts facts;  ///< see gcode::programFiles()
    Notes notes;          ///< notes of the reader
};

/// Errors as gcode::readProgram().
class ProgramStore : public FileCache<ProgramFile> {
public:
    ProgramStore() : FileCache(10) {}

protected:
    ProgramFile read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const override;
};

/// Errors as deflection::loadSetup().
class SetupStore : public FileCache<deflection::SetupFile> {
public:
    SetupStore() : FileCache(10) {}

protected:
    deflection::SetupFile read(const project::Source& source, io::InputFiles& inputs,
                               const Progress& progress) const override;
};

/// Loads the file of an input and records its name, digest, notes and synthetic mark in the outcome.
template <class Store, class Outcome>
auto takeFile(const project::PanelState& state, const char* role, Stores& stores, const Progress& progress,
              Outcome& outcome)
{
    const project::Source& source = state.inputs.at(role);
    auto loaded = stores.of<Store>()->load(source, progress);
    outcome.inputs.insert(outcome.inputs.end(), loaded->inputs.begin(), loaded->inputs.end());
    outcome.notes.insert(outcome.notes.end(), loaded->file.notes.begin(), loaded->file.notes.end());
    outcome.synthetic |= source.synthetic;
    return loaded;
}

/// A program before edits by the user.
struct ProgramInput {
    std::string text;                        ///< complete text
    std::string name;                        ///< path of the file, or name and digest of the item
    InputFile input;                         ///< description of the file or item for the report
    Notes notes;                             ///< notes of the reader
    std::optional<gcode::ProgramItem> item;  ///< program item; none: a file
};

/// Errors: those of ProgramStore; itemNotThere. Precondition: the input is given.
ProgramInput takenProgram(const project::PanelState& state, Stores& stores, const Progress& progress);

/// Path or item name of the program for errors.
std::string programName(const project::PanelState& state);

/// The text of the program, original or edited (note programEdited). Of the drafts of the question only the used one is
/// kept. The outcome receives name and digest of the input, its notes and the synthetic mark. `before`: the original
/// program.
template <class Outcome>
std::string takeProgram(const project::PanelState& state, Stores& stores, const Progress& progress, Outcome& outcome,
                        ProgramInput& before)
{
    before = takenProgram(state, stores, progress);
    outcome.inputs.push_back(before.input);
    outcome.notes.insert(outcome.notes.end(), before.notes.begin(), before.notes.end());
    outcome.synthetic |= state.inputs.at(programRole).synthetic;
    std::vector<ProgramDraft>& drafts = outcome.question.drafts;
    std::erase_if(drafts, [&](const ProgramDraft& draft) { return !isOf(draft, before.name, before.input.sha256); });
    if (drafts.empty()) return before.text;
    outcome.notes.push_back({notes::programEdited, {}});
    return bytesOf(drafts.front().text, before.text);
}

}  // namespace lathelier::deflection_common
