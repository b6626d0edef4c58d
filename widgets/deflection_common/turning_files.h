// NC programs and set-ups that were read, and how a computation takes them.
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
inline constexpr const char* setupRole = "setup";  ///< besides: shaftRole for the stock, spindleRole for the chuck

/// The text of a program and what was understood of it.
struct ProgramFile {
    std::string text;     ///< every byte
    io::FileFacts facts;  ///< as gcode::programFiles() has them
    Notes notes;          ///< of the reading
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

/// Loads the file of an input for a picture, which gets its name and digest, its notes, and whether it is synthetic.
template <class Store, class Picture>
auto takeFile(const project::PanelState& state, const char* role, Stores& stores, const Progress& progress,
              Picture& picture)
{
    const project::Source& source = state.inputs.at(role);
    auto loaded = stores.of<Store>()->load(source, progress);
    picture.inputs.insert(picture.inputs.end(), loaded->inputs.begin(), loaded->inputs.end());
    picture.notes.insert(picture.notes.end(), loaded->file.notes.begin(), loaded->file.notes.end());
    picture.synthetic |= source.synthetic;
    return loaded;
}

/// A program as it was taken, before what the user has changed of it.
struct TakenProgram {
    std::string text;                        ///< every byte
    std::string name;                        ///< path of the file, or name of the item with its digest
    InputFile input;                         ///< the file, or the item as if it had been one
    Notes notes;                             ///< of the reading
    std::optional<gcode::ProgramItem> item;  ///< none: a file
};

/// Errors: those of ProgramStore; itemNotThere. Precondition: the input is given.
TakenProgram takenProgram(const project::PanelState& state, Stores& stores, const Progress& progress);

/// What errors name as the file of the program: path, or name of the item.
std::string programName(const project::PanelState& state);

/// The text of the program: as it was taken, or what the user has made of it (noted: programEdited). Of the drafts of
/// the question the one that is used is kept. The picture gets name and digest of the input, its notes, and whether it
/// is synthetic. `before`: as it was taken.
template <class Picture>
std::string takeProgram(const project::PanelState& state, Stores& stores, const Progress& progress, Picture& picture,
                        TakenProgram& before)
{
    before = takenProgram(state, stores, progress);
    picture.inputs.push_back(before.input);
    picture.notes.insert(picture.notes.end(), before.notes.begin(), before.notes.end());
    picture.synthetic |= state.inputs.at(programRole).synthetic;
    std::vector<ProgramDraft>& drafts = picture.question.drafts;
    std::erase_if(drafts, [&](const ProgramDraft& draft) { return !isOf(draft, before.name, before.input.sha256); });
    if (drafts.empty()) return before.text;
    picture.notes.push_back({notes::programEdited, {}});
    return bytesOf(drafts.front().text, before.text);
}

}  // namespace lathelier::deflection_common
