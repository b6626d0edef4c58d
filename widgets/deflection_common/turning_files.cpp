#include "widgets/deflection_common/turning_files.h"

#include "engine/io/file.h"
#include "engine/project/project_codes.h"

namespace lathelier::deflection_common {
namespace {

constexpr std::size_t shownDigits = 12;

}  // namespace

ProgramFile ProgramStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    ProgramFile file;
    file.text = inputs.open(source.path, progress.part(0, 0.2));
    file.facts = gcode::programFiles().facts({source.path, file.text, source.import, inputs, progress}, file.notes);
    return file;
}

/// The digest in the name identifies the version of the item, since a draft belongs to one text.
ProgramInput takenProgram(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    const project::Source& source = state.inputs.at(programRole);
    ProgramInput taken;
    if (source.item.empty()) {
        const auto loaded = stores.of<ProgramStore>()->load(source, progress);
        taken.text = loaded->file.text;
        taken.name = source.path;
        taken.input = loaded->inputs.front();
        taken.notes = loaded->file.notes;
        return taken;
    }
    const auto item = state.items.find(programRole);
    if (item != state.items.end() && item->second.kind == gcode::programItem)
        taken.item = gcode::programOf(item->second.values);
    if (!taken.item)
        throw Error(errors::itemNotThere, {{"item", source.item}, {"kind", std::string(gcode::programItem)}});
    taken.text = taken.item->text;
    taken.input = {source.item, static_cast<std::int64_t>(taken.text.size()), io::sha256(taken.text)};
    taken.name = source.item + " · " + taken.input.sha256.substr(0, shownDigits);
    return taken;
}

std::string programName(const project::PanelState& state)
{
    const project::Source& source = state.inputs.at(programRole);
    return source.item.empty() ? source.path : source.item;
}

deflection::SetupFile SetupStore::read(const project::Source& source, io::InputFiles& inputs,
                                       const Progress& progress) const
{
    return deflection::loadSetup({source.path, inputs.open(source.path, progress), source.import, inputs, progress});
}

}  // namespace lathelier::deflection_common
