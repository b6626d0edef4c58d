#include "engine/task/inputs.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"

namespace lathelier::task {

void Sources::add(const std::vector<InputFile>& files, const Notes& of_reader, bool is_synthetic)
{
    inputs.insert(inputs.end(), files.begin(), files.end());
    for (Note note : of_reader) {
        // Several inputs may say the same: which file does is part of what was not understood.
        const bool isPlaced = note.code.role != NoteRole::Remark && !files.empty() && !find(note.values, "path");
        if (isPlaced) note.values.emplace_back("path", files.front().path);
        notes.push_back(std::move(note));
    }
    synthetic = synthetic || is_synthetic || contains(of_reader, lathelier::notes::syntheticData);
}

Input ofPart(Input input)
{
    input.is_of_part = true;
    return input;
}

const project::Source* sourceOf(const project::PanelState& state, const std::string& role)
{
    const auto source = state.inputs.find(role);
    return source == state.inputs.end() ? nullptr : &source->second;
}

std::string nameOf(const project::Source& source)
{
    return source.item.empty() ? source.path : source.item;
}

const Values& itemValues(const project::PanelState& state, const std::string& role, const char* kind)
{
    const auto item = state.items.find(role);
    if (item == state.items.end() || item->second.kind != kind) throwItemNotThere(state.inputs.at(role).item, kind);
    return item->second.values;
}

InputFile itemAsInput(const std::string& name, const std::string& content)
{
    return {name, static_cast<std::int64_t>(content.size()), io::sha256(content)};
}

std::string contentOf(const Values& values)
{
    return toJson(values).dump();
}

void throwItemNotThere(const std::string& item, const char* kind)
{
    throw Error(errors::itemNotThere, {{"item", item}, {"kind", std::string(kind)}});
}

}  // namespace lathelier::task
