#include "widgets/part_common/part_input.h"

#include <filesystem>

#include "engine/cad/part_input.h"
#include "engine/task/inputs.h"

namespace lathelier::part_common {

PartInput takePart(const project::PanelState& state, const std::string& role, Stores& stores, const Progress& progress)
{
    const project::Source& source = state.inputs.at(role);
    task::Sources sources;
    Shaft shaft = *task::take<cad::PartInput>(state, role, stores, progress, sources);
    PartInput taken{std::move(shaft), sources.inputs.front(), sources.notes, sources.synthetic, std::nullopt};
    if (!source.item.empty())
        taken.recovered = recoveredFrom(task::itemValues(state, role, shaftItem));
    else if (taken.shaft.name.empty())
        taken.shaft.name = std::filesystem::path(source.path).stem().string();
    return taken;
}

}  // namespace lathelier::part_common
