#include "widgets/trajectory_common/spindle_files.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/core/profile_item.h"
#include "engine/io/file.h"
#include "engine/project/project_codes.h"

namespace lathelier::trajectory_common {

io::ProbeFile RecordStore::read(const project::Source& source, io::InputFiles& inputs, const Progress& progress) const
{
    return io::readProbeRecord(source.path, inputs.open(source.path, progress), inputs,
                               fromValues<io::ImportOptions>(source.import),
                               fromValues<io::RecorderOptions>(source.import), progress);
}

io::ProfileFile ProfileStore::read(const project::Source& source, io::InputFiles& inputs,
                                   const Progress& progress) const
{
    return io::readProfile(source.path, inputs.open(source.path, progress),
                           fromValues<io::ImportOptions>(source.import), fromValues<io::ProfileOptions>(source.import),
                           progress);
}

LoadedProfilePtr profileFromItem(const project::Source& source, const std::string& role,
                                 const project::PanelState& state)
{
    const auto item = state.items.find(role);
    std::optional<Profile> profile;
    if (item != state.items.end() && item->second.kind == profileItem) profile = profileOf(item->second.values);
    if (!profile) throw Error(errors::itemNotThere, {{"item", source.item}, {"kind", std::string(profileItem)}});
    const std::string text = toJson(item->second.values).dump();
    auto loaded = std::make_shared<Loaded<io::ProfileFile>>();
    loaded->file.profile = std::move(*profile);
    loaded->inputs = {{source.item, static_cast<std::int64_t>(text.size()), io::sha256(text)}};
    return loaded;
}

}  // namespace lathelier::trajectory_common
