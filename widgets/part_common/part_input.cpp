#include "widgets/part_common/part_input.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "widgets/part_common/part_store.h"

namespace lathelier::part_common {
namespace {

PartInput fromItem(const project::PanelState& state, const std::string& role, const project::Source& source)
{
    const auto item = state.items.find(role);
    std::optional<Shaft> shaft;
    if (item != state.items.end() && item->second.kind == shaftItem) shaft = shaftOf(item->second.values);
    if (!shaft) throw Error(errors::itemNotThere, {{"item", source.item}, {"kind", std::string(shaftItem)}});
    const std::string content = toJson(item->second.values).dump();
    return {*std::move(shaft),
            {source.item, static_cast<std::int64_t>(content.size()), io::sha256(content)},
            {},
            source.synthetic,
            recoveredFrom(item->second.values)};
}

}  // namespace

PartInput takePart(const project::PanelState& state, const std::string& role, Stores& stores, const Progress& progress)
{
    const project::Source& source = state.inputs.at(role);
    if (!source.item.empty()) return fromItem(state, role, source);
    const auto loaded = stores.of<PartStore>()->load(source, progress);
    PartInput taken{loaded->file.shaft, loaded->inputs.front(), loaded->file.notes,
                    source.synthetic || contains(loaded->file.notes, notes::syntheticData), std::nullopt};
    if (taken.shaft.name.empty()) taken.shaft.name = std::filesystem::path(source.path).stem().string();
    return taken;
}

}  // namespace lathelier::part_common
