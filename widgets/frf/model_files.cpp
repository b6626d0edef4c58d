#include "widgets/frf/model_files.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/core/shaft_item.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "engine/receptance/shaft_file.h"
#include "engine/receptance/spindle_file.h"
#include "engine/receptance/spindle_item.h"

namespace lathelier::frf_panel {
namespace {

/// Calls `read`; its errors get the path.
template <class Read>
auto named(const std::string& path, Read read)
{
    try {
        return read();
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

/// From a file or an item: `part` gives the value within a file, `restored` that of an item.
template <class Store, class T, class Part, class Restored>
std::optional<Taken<T>> taken(const project::PanelState& state, const char* role, const char* kind, Stores& stores,
                              const Progress& progress, Part part, Restored restored)
{
    const auto at = state.inputs.find(role);
    if (at == state.inputs.end()) return std::nullopt;
    const project::Source& source = at->second;
    if (source.item.empty()) {
        const auto loaded = stores.of<Store>()->load(source, progress);
        return Taken<T>{loaded->file.*part, loaded->inputs.front(), loaded->file.notes,
                        source.synthetic || contains(loaded->file.notes, notes::syntheticData)};
    }
    const Values& values = itemOf(state, role, kind);
    std::optional<T> value = restored(values);
    if (!value) throw Error(errors::itemNotThere, {{"item", source.item}, {"kind", std::string(kind)}});
    return Taken<T>{*std::move(value), inputOfItem(source, values), {}, source.synthetic};
}

}  // namespace

ShaftFile ShaftStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    const std::string_view bytes = inputs.open(source.path, progress);
    return named(source.path, [&] {
        ShaftFile file;
        file.shaft = receptance::readShaftFile(bytes, file.notes, progress);
        return file;
    });
}

SpindleFile SpindleStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    const std::string_view bytes = inputs.open(source.path, progress);
    return named(source.path, [&] {
        SpindleFile file;
        file.spindle = receptance::readSpindle(std::string(bytes), file.notes);
        return file;
    });
}

std::optional<Taken<Shaft>> takeShaft(const project::PanelState& state, Stores& stores, const Progress& progress)
{
    return taken<ShaftStore, Shaft>(state, shaftRole, shaftItem, stores, progress, &ShaftFile::shaft,
                                    [](const Values& values) { return shaftOf(values); });
}

std::optional<Taken<receptance::SpindleReceptance>> takeSpindle(const project::PanelState& state, Stores& stores,
                                                                const Progress& progress)
{
    return taken<SpindleStore, receptance::SpindleReceptance>(
        state, spindleRole, receptance::spindleItem, stores, progress, &SpindleFile::spindle,
        [](const Values& values) { return receptance::spindleOf(values); });
}

const Values& itemOf(const project::PanelState& state, const char* role, const char* kind)
{
    const auto item = state.items.find(role);
    if (item != state.items.end() && item->second.kind == kind) return item->second.values;
    throw Error(errors::itemNotThere, {{"item", state.inputs.at(role).item}, {"kind", std::string(kind)}});
}

InputFile inputOfItem(const project::Source& source, const Values& values)
{
    const std::string content = toJson(values).dump();
    return {source.item, static_cast<std::int64_t>(content.size()), io::sha256(content)};
}

}  // namespace lathelier::frf_panel
