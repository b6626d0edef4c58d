#include "engine/cad/task/taken_part.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "engine/cad/step_reader.h"
#include "engine/io/file.h"
#include "engine/io/json/json_head.h"
#include "engine/io/json/json_locate.h"

namespace lathelier::cad {

PartTaken takePart(const project::PanelState& state, const std::string& role, Stores& stores, task::Sources& sources,
                   const Progress& progress)
{
    const project::Source& source = state.inputs.at(role);
    PartTaken taken;
    taken.file = task::takeFile<PartInput>(state, role, stores, progress, sources);
    if (!taken.file) {
        taken.shaft = *task::take<PartInput>(state, role, stores, progress, sources);
        return taken;
    }
    taken.shaft = taken.file->file.shaft;
    if (taken.shaft.name.empty()) taken.shaft.name = std::filesystem::path(source.path).stem().string();
    return taken;
}

void locatePart(Error& error, const project::Source& source)
{
    if (source.item.empty()) io::locateRow(error, source.path);
    error.with("path", task::nameOf(source));
}

void dropRepeated(task::Sources& sources, const Notes& remarks)
{
    std::erase_if(sources.notes, [&](const Note& note) {
        return std::any_of(remarks.begin(), remarks.end(),
                           [&](const Note& remark) { return remark.code == note.code; });
    });
}

bool isDrawing(std::string_view head)
{
    head = head.substr(0, io::headForKind);
    if (looksLikeStep(head)) return true;
    const std::vector<std::string> keys = io::keysOfHead(head);
    return io::hasKey(keys, "segments") && !io::hasKey(keys, "command");
}

}  // namespace lathelier::cad
